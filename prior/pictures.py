"""Contact sheets: rows of pictures side by side in one PNG."""

import numpy as np
from PIL import Image


def save_sheet(columns, path, rows=10):
    """Save columns [[n, 1 or 3, S, S], ...] with values 0..1 as a sheet of at most `rows` rows."""
    rows = min(rows, min(len(column) for column in columns))
    sheet = np.concatenate([np.concatenate([eight_bit(column[i]) for column in columns], 1) for i in range(rows)], 0)
    Image.fromarray(sheet).save(path)


def eight_bit(picture):
    """[1 or 3, H, W] in 0..1 -> uint8 [H, W, 3]."""
    picture = picture.detach().float().clamp(0, 1).expand(3, -1, -1)
    return (picture * 255).byte().permute(1, 2, 0).cpu().numpy()
