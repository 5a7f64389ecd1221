//! openflight/mod
