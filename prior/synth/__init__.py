"""Procedural photographs with exact truth, made on the GPU from nothing but seeds.

`objects` turns a seed into convex primitives, `materials` colours them, `environments` and `cameras` light and frame
them, `raycast` renders them, and `batches` puts it all together into what the networks train on.
"""
