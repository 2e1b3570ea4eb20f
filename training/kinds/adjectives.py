# SPDX-License-Identifier: MIT OR Apache-2.0
"""Adjectives: which measured quantity each one asks more or less of, and how each can be said.

The quantities that every shape has (`tall`, `wide`, `long`, `bulk`, `top`, `boxy`) are measured by
`shapes/attributes.py`; a family may add proportions of its own. A value is (quantity, +1 or -1).
"""

# Things that stand and have a front: seats, cabinets, houses, clocks.
STANDING = {
    "tall": ("tall", 1),
    "low": ("tall", -1),
    "wide": ("wide", 1),
    "narrow": ("wide", -1),
    "thick": ("bulk", 1),
    "slender": ("bulk", -1),
    "top-heavy": ("top", 1),
    "bottom-heavy": ("top", -1),
    "boxy": ("boxy", 1),
    "rounded": ("boxy", -1),
}
# Things turned on a wheel or lathe, with no front: bottles, cups, rockets, towers. Wide is squat.
TURNED = {**STANDING, "wide": ("tall", -1), "narrow": ("tall", 1), "slender": ("tall", 1)}
# Things longer than they are high: vehicles, boats, beds, tools.
LYING = {**STANDING, "long": ("long", 1), "short": ("long", -1)}

# Other ways to say an adjective.
FORMS = {
    "tall": ("taller", "high", "higher"),
    "low": ("lower", "squat"),
    "short": ("shorter", "stubby"),
    "wide": ("wider", "broad", "broader"),
    "narrow": ("narrower",),
    "long": ("longer", "elongated"),
    "thick": ("thicker", "chunky", "bulky", "fat", "fatter", "massive"),
    "slender": ("slim", "slimmer", "thin", "thinner", "skinny"),
    "top-heavy": (),
    "bottom-heavy": (),
    "boxy": ("boxier", "angular", "blocky"),
    "rounded": ("rounder", "curvy", "streamlined"),
    "deep": ("deeper",),
    "with long legs": ("with longer legs", "with tall legs", "with high legs", "long legged"),
    "with short legs": ("with shorter legs", "with low legs", "short legged"),
    "with a high back": ("with a higher back", "high backed", "with a tall back"),
    "with a low back": ("with a lower back", "low backed", "with a short back"),
    "with a high headboard": ("with a higher headboard", "with a tall headboard"),
    "with a thick top": ("with a thicker top", "with a heavy top"),
    "with a thin top": ("with a thinner top", "with a slim top"),
    "with a long neck": ("with a longer neck", "long necked"),
    "with a short neck": ("with a shorter neck", "short necked"),
    "with a big handle": ("with a bigger handle", "with a large handle"),
    "with a long stem": ("with a longer stem", "with a tall stem", "long stemmed"),
    "with a short stem": ("with a shorter stem", "short stemmed"),
    "with a long blade": ("with a longer blade", "long bladed"),
    "with a wide blade": ("with a wider blade", "with a broad blade"),
    "with a long handle": ("with a longer handle", "long handled"),
    "with a short handle": ("with a shorter handle", "short handled"),
    "with a big head": ("with a bigger head", "with a large head"),
    "with a small head": ("with a smaller head", "with a little head"),
    "with a wide guard": ("with a wider guard", "with a broad guard", "with a big guard"),
    "with big wheels": ("with bigger wheels", "with large wheels"),
    "with small wheels": ("with smaller wheels", "with tiny wheels"),
    "with a long hood": ("with a longer hood", "with a long bonnet"),
    "with a tall mast": ("with a taller mast", "with a high mast"),
    "with a big cabin": ("with a bigger cabin", "with a large cabin"),
    "shallow": ("shallower",),
    "flat": ("flatter",),
    "swept": ("swept back", "with swept wings", "swept winged"),
    "with long wings": ("with longer wings", "long winged", "with a wide wingspan", "with a long wingspan"),
    "with short wings": ("with shorter wings", "short winged", "with stubby wings", "with clipped wings"),
    "with a high tail": ("with a higher tail", "with a tall tail", "with a big tail", "with a tall fin"),
    "with a high roof": ("with a higher roof", "with a tall roof", "with a steep roof"),
    "with a flat roof": ("with a low roof", "with a flatter roof", "flat roofed"),
    "with a tall tower": ("with a taller tower", "with a high tower", "with a tall chimney"),
    "with high feet": ("with higher feet", "with tall feet", "with long feet"),
    "with big fins": ("with bigger fins", "with large fins", "with wide fins"),
    "with small fins": ("with smaller fins", "with tiny fins", "with short fins"),
    "with a long nose": ("with a longer nose", "long nosed", "with a pointed nose"),
    "with a short nose": ("with a shorter nose", "short nosed", "with a blunt nose"),
    "with a big shade": ("with a bigger shade", "with a large shade", "with a wide shade"),
    "with a small shade": ("with a smaller shade", "with a little shade", "with a narrow shade"),
    "with a big foot": ("with a bigger foot", "with a wide foot", "with a big base", "with a wide base"),
    "with a thick stem": ("with a thicker stem", "with a thick post"),
    "with a thin stem": ("with a thinner stem", "with a slender stem"),
    "with a big dial": ("with a bigger dial", "with a large dial", "with a big face"),
    "with a small dial": ("with a smaller dial", "with a small face"),
}
COMPARATIVES = {
    "big": "bigger",
    "small": "smaller",
    "long": "longer",
    "short": "shorter",
    "high": "higher",
    "low": "lower",
    "tall": "taller",
    "thick": "thicker",
    "thin": "thinner",
    "wide": "wider",
    "narrow": "narrower",
}


def forms(adjective):
    """All ways to say an adjective; of "with long legs" also "longer legs"."""
    if adjective in FORMS:
        return (adjective, *FORMS[adjective])
    compared = " ".join(COMPARATIVES.get(word, word) for word in adjective.split())
    return tuple(dict.fromkeys((adjective, compared)))
