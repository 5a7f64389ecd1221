//! Networks: engines, graphs, one file a family.
