//! PROJ's C library, for the coordinate systems that are not built in: the machine's own, looked for when one of them is asked
//! for. Nothing is linked, and a program without it does everything else.

use std::ffi::{CStr, CString, c_char, c_int, c_void};

use libloading::Library;

/// Four numbers by value, as PROJ's `PJ_COORD` (a union of structures of four doubles).
#[repr(C)]
#[derive(Clone, Copy)]
struct Coord([f64; 4]);

/// `PJ_TYPE` of proj.h: the kinds whose third axis is a height of its own.
const GEOCENTRIC: c_int = 10;
const GEOGRAPHIC_3D: c_int = 13;
const COMPOUND: c_int = 16;
const FORWARD: c_int = 1;
const INVERSE: c_int = -1;

/// A context or an object of PROJ, freed when dropped.
struct Owned {
    pointer: *mut c_void,
    free: Free,
}

impl Drop for Owned {
    fn drop(&mut self) {
        // SAFETY: `pointer` came from the function that `free` belongs to and is freed once, here.
        unsafe { (self.free)(self.pointer) };
    }
}

/// A point in WGS84.
pub(super) struct Converted {
    pub latitude: f64,
    pub longitude: f64,
    pub height: f64,
    /// The source system has a vertical axis of its own, so `height` is above the ellipsoid.
    pub vertical: bool,
    /// Metres on the ground that a unit of the first two axes is.
    pub metres_per_unit: f64,
}

/// By which names the system is asked for the library: PROJ 9's and 8's own, then whatever is installed for building.
const NAMES: &[&str] = if cfg!(target_os = "windows") {
    &["proj_9.dll", "proj.dll"]
} else if cfg!(target_os = "macos") {
    &["libproj.25.dylib", "libproj.22.dylib", "libproj.dylib"]
} else {
    &["libproj.so.25", "libproj.so.22", "libproj.so"]
};

/// `PJ_INFO` of proj.h.
#[repr(C)]
struct Info {
    version: [c_int; 3],
    release: *const c_char,
    written: *const c_char,
    search_path: *const c_char,
    paths: *const *const c_char,
    path_count: usize,
}

type Free = unsafe extern "C" fn(*mut c_void) -> *mut c_void;

/// What is called of the library (PROJ 6.2 or newer; proj.h).
pub(super) struct Proj {
    info: unsafe extern "C" fn() -> Info,
    context_create: unsafe extern "C" fn() -> *mut c_void,
    context_destroy: Free,
    context_set_enable_network: unsafe extern "C" fn(*mut c_void, c_int) -> c_int,
    create: unsafe extern "C" fn(*mut c_void, *const c_char) -> *mut c_void,
    create_crs_to_crs_from_pj: unsafe extern "C" fn(
        *mut c_void,
        *const c_void,
        *const c_void,
        *mut c_void,
        *const *const c_char,
    ) -> *mut c_void,
    destroy: Free,
    trans: unsafe extern "C" fn(*mut c_void, c_int, Coord) -> Coord,
    get_type: unsafe extern "C" fn(*const c_void) -> c_int,
    context_errno: unsafe extern "C" fn(*mut c_void) -> c_int,
    errno: unsafe extern "C" fn(*const c_void) -> c_int,
    context_errno_string: unsafe extern "C" fn(*mut c_void, c_int) -> *const c_char,
}

/// Major, minor and patch of the PROJ that this machine has.
pub fn version() -> Option<[i32; 3]> {
    Proj::find().map(|proj| proj.version())
}

impl Proj {
    /// The machine's own PROJ; `None` where it has none.
    pub fn find() -> Option<Proj> {
        Proj::load(NAMES)
    }

    /// The first of the libraries of these names that is one and has all the calls.
    pub fn load(names: &[&str]) -> Option<Proj> {
        names.iter().find_map(|name| {
            // SAFETY: what runs when a library of this name is loaded is PROJ's, as it is for a program that is linked to it;
            // the functions have the types that proj.h gives them. It is never unloaded, so that they stay.
            unsafe {
                let library = Library::new(*name).ok()?;
                let proj = Proj {
                    info: *library.get(b"proj_info\0").ok()?,
                    context_create: *library.get(b"proj_context_create\0").ok()?,
                    context_destroy: *library.get(b"proj_context_destroy\0").ok()?,
                    context_set_enable_network: *library.get(b"proj_context_set_enable_network\0").ok()?,
                    create: *library.get(b"proj_create\0").ok()?,
                    create_crs_to_crs_from_pj: *library.get(b"proj_create_crs_to_crs_from_pj\0").ok()?,
                    destroy: *library.get(b"proj_destroy\0").ok()?,
                    trans: *library.get(b"proj_trans\0").ok()?,
                    get_type: *library.get(b"proj_get_type\0").ok()?,
                    context_errno: *library.get(b"proj_context_errno\0").ok()?,
                    errno: *library.get(b"proj_errno\0").ok()?,
                    context_errno_string: *library.get(b"proj_context_errno_string\0").ok()?,
                };
                std::mem::forget(library);
                Some(proj)
            }
        })
    }

    /// Major, minor and patch.
    pub fn version(&self) -> [i32; 3] {
        // SAFETY: takes nothing and returns numbers and pointers to constants, which are not read.
        unsafe { (self.info)() }.version
    }

    /// From a system in the order of its own axes to WGS84. PROJ never fetches grids here, and a conversion that lacks its
    /// grid is refused instead of being done roughly.
    ///
    /// # Errors
    /// PROJ's own words.
    pub fn to_wgs84(&self, code: &str, point: [f64; 3]) -> Result<Converted, String> {
        let text = |t: &str| CString::new(t).map_err(|e| e.to_string());
        let (code, wgs84, option) = (text(code)?, text("EPSG:4979")?, text("ALLOW_BALLPARK=NO")?);
        // SAFETY: every pointer handed to PROJ is one that PROJ made and that `Owned` keeps alive, a C string that lives to
        // the end of this function, or null where proj.h allows it.
        unsafe {
            let context = Owned { pointer: (self.context_create)(), free: self.context_destroy };
            (self.context_set_enable_network)(context.pointer, 0);
            let why = |number: c_int| {
                let words = (self.context_errno_string)(context.pointer, number);
                if words.is_null() {
                    format!("error {number}")
                } else {
                    CStr::from_ptr(words).to_string_lossy().into_owned()
                }
            };
            let open = |definition: &CString| {
                let pointer = (self.create)(context.pointer, definition.as_ptr());
                if pointer.is_null() {
                    Err(why((self.context_errno)(context.pointer)))
                } else {
                    Ok(Owned { pointer, free: self.destroy })
                }
            };
            let (from, to) = (open(&code)?, open(&wgs84)?);
            let options = [option.as_ptr(), std::ptr::null()];
            let pointer = (self.create_crs_to_crs_from_pj)(
                context.pointer,
                from.pointer,
                to.pointer,
                std::ptr::null_mut(),
                options.as_ptr(),
            );
            if pointer.is_null() {
                return Err(format!("no conversion to WGS84 ({})", why((self.context_errno)(context.pointer))));
            }
            let conversion = Owned { pointer, free: self.destroy };
            let convert =
                |p: [f64; 3]| (self.trans)(conversion.pointer, FORWARD, Coord([p[0], p[1], p[2], f64::INFINITY])).0;
            let [latitude, longitude, height, _] = convert(point);
            if ![latitude, longitude, height].iter().all(|v| v.is_finite()) {
                return Err(format!("the point cannot be converted ({})", why((self.errno)(conversion.pointer))));
            }
            // Far outside a projection's area some versions answer with a point all the same: not one that leads back.
            let back = (self.trans)(conversion.pointer, INVERSE, Coord([latitude, longitude, height, f64::INFINITY])).0;
            let leads_back = |i: usize| (back[i] - point[i]).abs() <= 1e-6 * point[i].abs() + 1e-6;
            if !(leads_back(0) && leads_back(1)) {
                return Err("the point cannot be converted (it lies outside the area of its coordinate system)".into());
            }
            let beside = convert([point[0] + 1e-3, point[1], point[2]]);
            let east = (beside[1] - longitude) * latitude.to_radians().cos();
            Ok(Converted {
                latitude,
                longitude,
                height,
                vertical: matches!((self.get_type)(from.pointer), GEOCENTRIC | GEOGRAPHIC_3D | COMPOUND),
                metres_per_unit: (beside[0] - latitude).hypot(east) * 111_320.0 / 1e-3,
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::written::parse_point;
    use super::Proj;
    use crate::geo::AltDatum;

    /// Skips where the machine has no PROJ; fails under ORB_REQUIRE_CLIENTS=1.
    fn has_proj() -> bool {
        let found = Proj::find().is_some();
        assert!(found || std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "cannot run: PROJ is not installed");
        found
    }

    #[test]
    fn what_is_no_proj_is_not_taken_for_one() {
        assert!(Proj::load(&["libnothing-of-this-name.so"]).is_none());
        if cfg!(target_os = "linux") {
            assert!(Proj::load(&["libm.so.6"]).is_none(), "it has none of the calls");
        }
        if has_proj() {
            let [major, ..] = Proj::find().unwrap().version();
            assert!((6..100).contains(&major), "{major}");
        }
    }

    /// swisstopo's own example (CH1903+ to WGS84: 46°2'38.87" N 8°43'49.79" E), good to a metre; and EPSG:27700, EPSG:5514.
    #[test]
    fn other_codes_through_proj() {
        if !has_proj() {
            return;
        }
        let p = parse_point("p", "EPSG:2056 2700000,1100000").unwrap();
        assert!((p.latitude - 46.044_130_6).abs() < 2e-5 && (p.longitude - 8.730_497_2).abs() < 2e-5, "{p:?}");
        assert_eq!((p.height, p.height_datum), (None, None));
        assert!((p.rounding - 0.5).abs() < 0.05);
        let [major, minor, patch] = p.proj.unwrap();
        assert_eq!(p.read_as(), format!("EPSG code (PROJ {major}.{minor}.{patch})"));
        let p = parse_point("p", "EPSG:4326+5773 34.5523,-118.4712,740").unwrap();
        assert_eq!(p.height_datum, Some(AltDatum::Ellipsoid));
        // PROJ interpolates its 15-minute grid linearly; ours is the model itself.
        let ours = 740.0 + crate::geo::geoid::undulation(34.5523, -118.4712);
        assert!((p.height.unwrap() - ours).abs() < 0.3, "{p:?} {ours}");
    }

    #[test]
    fn what_proj_cannot_do_is_said() {
        if !has_proj() {
            return;
        }
        for text in ["EPSG:999999 1,2", "EPSG:2056 1e30,1e30"] {
            let e = parse_point("--origin", text).unwrap_err().to_string();
            assert!(e.contains("EPSG:"), "{e}");
        }
        // No grid of EGM2008 comes with Debian's PROJ: refused, not done roughly.
        if !std::path::Path::new("/usr/share/proj/us_nga_egm08_25.tif").exists() {
            let e = parse_point("--origin", "EPSG:4326+3855 34.5,-118.4,740");
            assert!(e.is_err(), "{e:?}");
        }
    }
}
