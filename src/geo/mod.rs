//! WGS84, local frames, scale and placement; everything on the Earth in f64.
