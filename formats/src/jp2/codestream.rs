//! The one call into OpenJPEG: pixels to a codestream, reversible wavelet 5-3, all bits kept.

use std::ffi::c_void;
use std::ptr;

use openjpeg_sys as opj;

use super::FORMAT;
use crate::{Error, Image, Result};

/// What the library has made so far, and where it writes next: it goes back to fill in lengths.
#[derive(Default)]
struct Output {
    bytes: Vec<u8>,
    at: usize,
}

/// The library's objects, given back whatever happens.
struct Objects {
    image: *mut opj::opj_image_t,
    codec: *mut opj::opj_codec_t,
    stream: *mut opj::opj_stream_t,
}

impl Drop for Objects {
    fn drop(&mut self) {
        // SAFETY: each pointer is null, which the library's functions take, or came from its own constructor and is
        // dropped here only.
        unsafe {
            opj::opj_stream_destroy(self.stream);
            opj::opj_destroy_codec(self.codec);
            opj::opj_image_destroy(self.image);
        }
    }
}

/// Encodes an image whose sides and pixels were checked.
pub fn encode(image: &Image) -> Result<Vec<u8>> {
    let refused = || Error::unsupported(FORMAT, "OpenJPEG could not encode the image");
    let (width, height, channels) = (image.width, image.height, usize::from(image.channels));
    let component =
        opj::opj_image_cmptparm_t { dx: 1, dy: 1, w: width, h: height, x0: 0, y0: 0, prec: 8, bpp: 8, sgnd: 0 };
    let mut components = [component; 3];
    let space = match channels {
        3 => opj::OPJ_COLOR_SPACE::OPJ_CLRSPC_SRGB,
        _ => opj::OPJ_COLOR_SPACE::OPJ_CLRSPC_GRAY,
    };
    let mut output = Output::default();
    // SAFETY: `components` has at least `channels` entries, and the constructors take nothing else.
    let objects = unsafe {
        Objects {
            image: opj::opj_image_create(channels as u32, components.as_mut_ptr(), space),
            codec: opj::opj_create_compress(opj::OPJ_CODEC_FORMAT::OPJ_CODEC_J2K),
            stream: opj::opj_stream_default_create(0),
        }
    };
    if objects.image.is_null() || objects.codec.is_null() || objects.stream.is_null() {
        return Err(refused());
    }
    // SAFETY: the image was made with `channels` components, each with room for width · height samples, as checked
    // before against `image.pixels`.
    unsafe {
        let target = &mut *objects.image;
        (target.x1, target.y1) = (width, height);
        for c in 0..channels {
            let data = (*target.comps.add(c)).data;
            for (i, pixel) in image.pixels.chunks_exact(channels).enumerate() {
                *data.add(i) = pixel[c].into();
            }
        }
    }
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get().min(64) as i32);
    // SAFETY: a structure of numbers and pointers, for which all zero bits are a value; the library then sets it.
    let mut parameters: opj::opj_cparameters_t = unsafe { std::mem::zeroed() };
    // SAFETY: pointers to live values of the library's types; `output` outlives the stream, which `objects` drops
    // before `output` is used again, and only the functions below touch it.
    let done = unsafe {
        opj::opj_set_default_encoder_parameters(&mut parameters);
        parameters.tcp_numlayers = 1;
        parameters.tcp_rates[0] = 0.0;
        parameters.cp_disto_alloc = 1;
        parameters.tcp_mct = (channels == 3).into();
        // A side of 2ⁿ can be halved n times.
        parameters.numresolution = 1 + width.min(height).ilog2().min(5) as i32;
        let (codec, stream) = (objects.codec, objects.stream);
        opj::opj_stream_set_user_data(stream, ptr::from_mut(&mut output).cast(), None);
        opj::opj_stream_set_write_function(stream, Some(write));
        opj::opj_stream_set_skip_function(stream, Some(skip));
        opj::opj_stream_set_seek_function(stream, Some(seek));
        opj::opj_setup_encoder(codec, &mut parameters, objects.image) != 0
            // Code blocks side by side, which no byte depends on. Where there are no threads, this one does all.
            && matches!(opj::opj_codec_set_threads(codec, threads), 0 | 1)
            && opj::opj_start_compress(codec, objects.image, stream) != 0
            && opj::opj_encode(codec, stream) != 0
            && opj::opj_end_compress(codec, stream) != 0
    };
    drop(objects);
    if done { Ok(output.bytes) } else { Err(refused()) }
}

unsafe extern "C" fn write(buffer: *mut c_void, count: usize, output: *mut c_void) -> usize {
    // SAFETY: the library hands back the pointer that it was given, and a buffer of `count` bytes.
    let (output, bytes) =
        unsafe { (&mut *output.cast::<Output>(), std::slice::from_raw_parts(buffer.cast::<u8>(), count)) };
    let end = output.at + count;
    if output.bytes.len() < end {
        output.bytes.resize(end, 0);
    }
    output.bytes[output.at..end].copy_from_slice(bytes);
    output.at = end;
    count
}

unsafe extern "C" fn skip(count: i64, output: *mut c_void) -> i64 {
    // SAFETY: as above.
    let output = unsafe { &mut *output.cast::<Output>() };
    match usize::try_from(count).ok().and_then(|n| output.at.checked_add(n)) {
        Some(at) => {
            output.at = at;
            count
        }
        None => -1,
    }
}

unsafe extern "C" fn seek(place: i64, output: *mut c_void) -> i32 {
    // SAFETY: as above.
    let output = unsafe { &mut *output.cast::<Output>() };
    match usize::try_from(place) {
        Ok(at) => {
            output.at = at;
            1
        }
        Err(_) => 0,
    }
}
