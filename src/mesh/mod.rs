//! From rendered depth to a textured mesh in levels of detail.
