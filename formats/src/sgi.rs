//! sgi
