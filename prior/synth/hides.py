"""The colours and the skins that the makers of animals true to their anatomy share."""

from .animals import fur

SAND, SILVER, GOLD, SLATE, FAWN = (0.55, 0.38, 0.2), (0.45, 0.45, 0.44), (0.62, 0.38, 0.14), (0.1, 0.12, 0.15), (0.5, 0.33, 0.19)


def skin(kit, *colours, gloss=0.25, **fixed):
    return fur(kit, *colours, gloss=gloss, **fixed)
