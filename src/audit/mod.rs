//! Marking, record, seal, verification, and the only door to the user's folders.
