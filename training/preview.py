# SPDX-License-Identifier: MIT OR Apache-2.0
"""A sheet of random shapes of a family, one row a kind, with their measured distances: look before training.

`python training/preview.py cars out.png`; under each shape its squared distance to the kind it was drawn
from and the nearest kind. `--scaled` shows them scaled part by part, as training does.
"""

import argparse

import boxmorph
import numpy as np
from draw import draw
from families import FAMILIES
from PIL import Image, ImageDraw
from shapes.shape import scale_parts
from truth import truth

SIDE = 128


def sheet(module, columns, seed, scaled=0.0, names=None):
    """The sheet as a PIL image."""
    family = FAMILIES[module]
    rows = names or [*family.kinds, None]
    captions = [(module, k) for k in family.kinds]
    picture = Image.new("RGB", (110 + columns * SIDE, len(rows) * (SIDE + 14)), "white")
    pen = ImageDraw.Draw(picture)
    for r, name in enumerate(rows):
        top = r * (SIDE + 14)
        pen.text((4, top + 50), name or "anywhere", fill="black")
        for c in range(columns):
            rng = np.random.default_rng((seed, r, c))
            shape = family.build(*draw(family, rng, name), rng)
            if scaled:
                scale_parts(shape, rng, scaled)
            gaps, _ = truth(shape, FAMILIES, captions)
            vertices, triangles = shape.mesh()
            view = boxmorph.render(vertices, triangles, size=SIDE, views="paper", renderer="cpu")[c % 2]
            picture.paste(Image.fromarray(view[..., :3]), (110 + c * SIDE, top))
            best = int(np.argmin(gaps))
            own = f"{gaps[captions.index((module, name))]:.1f} " if name else ""
            pen.text((112 + c * SIDE, top + SIDE), f"{own}{captions[best][1]} {gaps[best]:.1f}", fill="black")
    return picture


def gallery(columns=17, side=96):
    """One shape of every kind, family by family, on white, as a PIL image."""
    tiles = [(family, kind) for family in FAMILIES.values() for kind in family.kinds]
    rows = -(-len(tiles) // columns)
    picture = Image.new("RGB", (columns * side, rows * (side + 12)), "white")
    pen = ImageDraw.Draw(picture)
    for i, (family, kind) in enumerate(tiles):
        shape = typical(family, kind)
        vertices, triangles = shape.mesh()
        view = boxmorph.render(vertices, triangles, size=side, views="paper", renderer="cpu")[0]
        x, y = i % columns * side, i // columns * (side + 12)
        tile = Image.fromarray(view, "RGBA")
        picture.paste(tile, (x, y), tile)
        pen.text((x + 3, y + side - 2), kind, fill="black", font_size=9)
    return picture


def typical(family, kind, tries=6):
    """The shape nearest to its kind of a few drawn."""
    names = [(family.module, kind)]
    shapes = []
    for number in range(tries):
        rng = np.random.default_rng((3, number))
        shape = family.build(*draw(family, rng, kind), rng)
        shapes.append((truth(shape, FAMILIES, names)[0][0], number, shape))
    return min(shapes, key=lambda s: s[:2])[2]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("family", help="a module of families.py, or `all` for one shape of every kind")
    parser.add_argument("out")
    parser.add_argument("--kinds", nargs="*")
    parser.add_argument("--columns", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--scaled", type=float, default=0.0)
    a = parser.parse_args()
    if a.family == "all":
        gallery().save(a.out)
    else:
        sheet(a.family, a.columns, a.seed, a.scaled, a.kinds).save(a.out)
