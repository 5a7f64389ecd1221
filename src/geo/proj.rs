//! PROJ's C library, for the coordinate systems that are not built in (cargo feature `proj`).

use std::ffi::{CStr, CString, c_char, c_int, c_void};

/// Four numbers by value, as PROJ's `PJ_COORD` (a union of structures of four doubles).
#[repr(C)]
#[derive(Clone, Copy)]
struct Coord([f64; 4]);

#[link(name = "proj")]
unsafe extern "C" {
    fn proj_context_create() -> *mut c_void;
    fn proj_context_destroy(context: *mut c_void) -> *mut c_void;
    fn proj_context_set_enable_network(context: *mut c_void, on: c_int) -> c_int;
    fn proj_create(context: *mut c_void, definition: *const c_char) -> *mut c_void;
    fn proj_create_crs_to_crs_from_pj(
        context: *mut c_void,
        from: *const c_void,
        to: *const c_void,
        area: *mut c_void,
        options: *const *const c_char,
    ) -> *mut c_void;
    fn proj_destroy(pj: *mut c_void) -> *mut c_void;
    fn proj_trans(pj: *mut c_void, direction: c_int, coord: Coord) -> Coord;
    fn proj_get_type(pj: *const c_void) -> c_int;
    fn proj_context_errno(context: *mut c_void) -> c_int;
    fn proj_errno(pj: *const c_void) -> c_int;
    fn proj_context_errno_string(context: *mut c_void, code: c_int) -> *const c_char;
}

/// `PJ_TYPE` of proj.h: the kinds whose third axis is a height of its own.
const GEOCENTRIC: c_int = 10;
const GEOGRAPHIC_3D: c_int = 13;
const COMPOUND: c_int = 16;
const FORWARD: c_int = 1;
const INVERSE: c_int = -1;

/// A context or an object of PROJ, freed when dropped.
struct Owned {
    pointer: *mut c_void,
    free: unsafe extern "C" fn(*mut c_void) -> *mut c_void,
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

/// From a system in the order of its own axes to WGS84. PROJ never fetches grids here, and a conversion that lacks its
/// grid is refused instead of being done roughly.
///
/// # Errors
/// PROJ's own words.
pub(super) fn to_wgs84(code: &str, point: [f64; 3]) -> Result<Converted, String> {
    let text = |t: &str| CString::new(t).map_err(|e| e.to_string());
    let (code, wgs84, option) = (text(code)?, text("EPSG:4979")?, text("ALLOW_BALLPARK=NO")?);
    // SAFETY: every pointer handed to PROJ is one that PROJ made and that `Owned` keeps alive, a C string that lives to
    // the end of this function, or null where proj.h allows it.
    unsafe {
        let context = Owned { pointer: proj_context_create(), free: proj_context_destroy };
        proj_context_set_enable_network(context.pointer, 0);
        let why = |number: c_int| {
            let words = proj_context_errno_string(context.pointer, number);
            if words.is_null() {
                format!("error {number}")
            } else {
                CStr::from_ptr(words).to_string_lossy().into_owned()
            }
        };
        let open = |definition: &CString| {
            let pointer = proj_create(context.pointer, definition.as_ptr());
            if pointer.is_null() {
                Err(why(proj_context_errno(context.pointer)))
            } else {
                Ok(Owned { pointer, free: proj_destroy })
            }
        };
        let (from, to) = (open(&code)?, open(&wgs84)?);
        let options = [option.as_ptr(), std::ptr::null()];
        let pointer = proj_create_crs_to_crs_from_pj(
            context.pointer,
            from.pointer,
            to.pointer,
            std::ptr::null_mut(),
            options.as_ptr(),
        );
        if pointer.is_null() {
            return Err(format!("no conversion to WGS84 ({})", why(proj_context_errno(context.pointer))));
        }
        let conversion = Owned { pointer, free: proj_destroy };
        let convert = |p: [f64; 3]| proj_trans(conversion.pointer, FORWARD, Coord([p[0], p[1], p[2], f64::INFINITY])).0;
        let [latitude, longitude, height, _] = convert(point);
        if ![latitude, longitude, height].iter().all(|v| v.is_finite()) {
            return Err(format!("the point cannot be converted ({})", why(proj_errno(conversion.pointer))));
        }
        // Far outside a projection's area some versions answer with a point all the same: not one that leads back.
        let back = proj_trans(conversion.pointer, INVERSE, Coord([latitude, longitude, height, f64::INFINITY])).0;
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
            vertical: matches!(proj_get_type(from.pointer), GEOCENTRIC | GEOGRAPHIC_3D | COMPOUND),
            metres_per_unit: (beside[0] - latitude).hypot(east) * 111_320.0 / 1e-3,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::written::parse_point;
    use crate::geo::AltDatum;

    /// swisstopo's own example (CH1903+ to WGS84: 46°2'38.87" N 8°43'49.79" E), good to a metre; and EPSG:27700, EPSG:5514.
    #[test]
    fn other_codes_through_proj() {
        let p = parse_point("p", "EPSG:2056 2700000,1100000").unwrap();
        assert!((p.latitude - 46.044_130_6).abs() < 2e-5 && (p.longitude - 8.730_497_2).abs() < 2e-5, "{p:?}");
        assert_eq!((p.height, p.height_datum), (None, None));
        assert!((p.rounding - 0.5).abs() < 0.05);
        let p = parse_point("p", "EPSG:4326+5773 34.5523,-118.4712,740").unwrap();
        assert_eq!(p.height_datum, Some(AltDatum::Ellipsoid));
        // PROJ interpolates its 15-minute grid linearly; ours is the model itself.
        let ours = 740.0 + crate::geo::geoid::undulation(34.5523, -118.4712);
        assert!((p.height.unwrap() - ours).abs() < 0.3, "{p:?} {ours}");
    }

    #[test]
    fn what_proj_cannot_do_is_said() {
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
