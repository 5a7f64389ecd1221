//! Camera rigs and the six views (paper Eq. 2–3).
