# SPDX-License-Identifier: MIT OR Apache-2.0
"""The families: geometry of `shapes/` and words of `kinds/` brought together under one name each."""

from dataclasses import dataclass
from importlib import import_module

# Module (in shapes/ and kinds/) of every family, and its share of the shapes drawn.
MODULES = {
    "seats": 1.6,
    "tables": 1.6,
    "aeroplanes": 1.7,
    "cabinets": 1.0,
    "beds": 0.8,
    "lamps": 1.0,
    "bottles": 0.9,
    "cups": 0.9,
    "cars": 1.2,
    "boats": 1.1,
    "rockets": 0.8,
    "guitars": 0.8,
    "blades": 0.9,
    "buildings": 1.0,
    "bathtubs": 0.7,
    "clocks": 0.8,
}


@dataclass(frozen=True)
class Family:
    """One family of manufactured things.

    `word` names all of it; `kinds` maps a name to its Kind; `axes` are the proportions a builder takes,
    `measured` those and the ones only measured; `adjectives` maps an adjective to (quantity, sign).
    `build(parameters, traits, rng)` gives a Shape, `measure(shape)` its proportions and faults, and
    `resembles(shape, proportions)` the same shape seen as another family: (module, proportions, traits), or
    None.
    """

    module: str
    word: str
    synonyms: tuple
    kinds: dict
    adjectives: dict
    axes: dict
    measured: dict
    build: object
    measure: object
    resembles: object
    share: float

    @property
    def quantities(self):
        """The quantities that the adjectives grade, in order."""
        return list(dict.fromkeys(quantity for quantity, _ in self.adjectives.values()))


def load(module):
    """The family of one module name."""
    shapes, words = import_module(f"shapes.{module}"), import_module(f"kinds.{module}")
    return Family(
        module,
        words.WORD,
        words.SYNONYMS,
        words.KINDS,
        words.ADJECTIVES,
        shapes.RANGES,
        {**shapes.RANGES, **getattr(shapes, "MEASURED", {})},
        shapes.build,
        shapes.measure,
        getattr(shapes, "resembles", lambda shape, proportions: None),
        MODULES[module],
    )


def load_all():
    """All families in order, by module name."""
    return {module: load(module) for module in MODULES}


FAMILIES = load_all()
# Every name, family by family: (module, kind), then (module, None) for the family's own word.
NAMES = [(m, kind) for m, f in FAMILIES.items() for kind in (*f.kinds, None)]
