# SPDX-License-Identifier: MIT OR Apache-2.0
"""Words: the ways to say each caption, and the tokenizer that knows which words are known."""

import json

from kinds import ATTRIBUTES, CAPTIONS, FAMILY_WORDS, KINDS

LENGTH = 16
PAD, UNKNOWN = "[PAD]", "[UNK]"

# Words that carry no meaning here: known, never reported, and weightless in the text encoder.
FILLERS = (
    "a an the this that one some my our of with and in on for as is it to photo picture image render "
    "rendering drawing 3d model shape object design view modern new kind type style . , ! ? - ' \""
).split()

SYNONYMS = {
    "chair": ["dining chair", "kitchen chair", "side chair"],
    "bar stool": ["barstool", "counter stool", "high stool", "bar chair"],
    "stool": ["wooden stool", "backless stool"],
    "sofa": ["couch", "settee", "three seater sofa", "long sofa"],
    "loveseat": ["love seat", "small sofa", "two seater sofa", "small couch"],
    "armchair": ["arm chair", "easy chair", "club chair"],
    "throne": ["royal throne", "royal chair", "high back chair"],
    "bench": ["park bench", "garden bench", "long bench"],
    "lounge chair": ["lounge seat", "lounger"],
    "chaise longue": ["chaise lounge", "chaise", "daybed", "day bed"],
    "ottoman": ["pouf", "pouffe", "footstool", "foot stool", "hassock"],
    "office chair": ["desk chair", "swivel chair", "task chair"],
    "coffee table": ["cocktail table", "low coffee table"],
    "dining table": ["dinner table", "kitchen table"],
    "desk": ["writing desk", "office desk", "writing table", "study table"],
    "console table": ["console", "hall table", "hallway table", "sofa table"],
    "side table": ["end table", "occasional table"],
    "nightstand": ["night stand", "bedside table", "night table", "bedside cabinet"],
    "bar table": ["high table", "pub table", "bistro table"],
    "square table": ["square shaped table"],
    "round table": ["circular table"],
    "conference table": ["meeting table", "boardroom table", "banquet table"],
    "sideboard": ["buffet", "credenza"],
    "chest of drawers": ["dresser", "chest", "drawers", "commode"],
    "table lamp": ["bedside lamp"],
    "floor lamp": ["standing lamp", "floor light"],
    "desk lamp": ["reading lamp", "work lamp", "task lamp", "anglepoise", "desk light"],
    "street lamp": ["street light", "streetlight", "lamp post", "lamppost", "streetlamp"],
    "mushroom lamp": ["mushroom light"],
    "airliner": ["passenger plane", "passenger jet", "jet airliner", "jumbo jet", "commercial plane"],
    "fighter jet": ["fighter", "jet fighter", "fighter plane", "warplane"],
    "glider plane": ["glider", "sailplane"],
    "airship": ["zeppelin", "blimp", "dirigible"],
    "propeller plane": ["prop plane", "light aircraft", "light plane"],
    "biplane": ["double decker plane"],
    "supersonic jet": ["concorde", "supersonic airliner", "supersonic plane"],
    "missile": ["rocket", "cruise missile"],
    "seat": [],
    "table": [],
    "lamp": ["light"],
    "aeroplane": ["airplane", "plane", "aircraft"],
}
# Adjectives by the word the attribute table uses.
ADJECTIVES = {
    "tall": ["tall", "taller", "high", "higher"],
    "low": ["low", "lower", "short", "shorter"],
    "wide": ["wide", "wider", "broad", "broader"],
    "narrow": ["narrow", "narrower", "slim"],
    "long": ["long", "longer", "elongated"],
    "short": ["short", "shorter", "small", "low", "lower"],
    "slender": ["slender", "slim", "slimmer", "thin", "thinner"],
    "fat": ["fat", "fatter", "thick", "thicker", "bulky"],
}
WIDE_PLANE = ["wide", "wider", "long winged", "wide winged"]


def phrases(caption):
    """All ways to say a caption, without articles."""
    words = caption.split()
    if len(words) == 2 and (words[0], words[1]) in ATTRIBUTES:
        adjectives = WIDE_PLANE if words == ["wide", "aeroplane"] else ADJECTIVES[words[0]]
        return [
            f"{a} {n}"
            for a in adjectives
            for n in [words[1], *SYNONYMS.get(words[1], [])[-3:]]
            if n.count(" ") == 0
        ]
    return [caption, *SYNONYMS[caption]]


def attribute_of(family):
    """Attribute captions of a family as (index into CAPTIONS, adjective)."""
    start = len(CAPTIONS) - len(ATTRIBUTES)
    return [(start + i, a) for i, ((a, _), v) in enumerate(ATTRIBUTES.items()) if v[0] == family]


def vocabulary():
    """Token to id: padding, unknown, fillers, then every content word and its plural, sorted."""
    words = {w for c in CAPTIONS for p in phrases(c) for w in p.split()}
    words |= {plural(w) for w in words}
    words |= {w for forms in ADJECTIVES.values() for w in forms}
    return {w: i for i, w in enumerate([PAD, UNKNOWN, *FILLERS, *sorted(words - set(FILLERS))])}


def plural(word):
    """The regular plural of an English noun."""
    if word.endswith(("s", "x", "ch", "sh")):
        return word + "es" if not word.endswith("drawers") else word
    return word + "s"


def plural_pairs():
    """(plural id, singular id) of every content word: the text encoder gives both one meaning."""
    ids = vocabulary()
    return [
        (ids[plural(w)], i)
        for w, i in ids.items()
        if plural(w) in ids and plural(w) != w and w not in FILLERS
    ]


def tokenizer_json():
    """The tokenizer in the format of the Hugging Face `tokenizers` library: words, lower case, padded to
    LENGTH.
    """
    ids = vocabulary()
    special = [
        {
            "id": ids[t],
            "content": t,
            "single_word": False,
            "lstrip": False,
            "rstrip": False,
            "normalized": False,
            "special": True,
        }
        for t in (PAD, UNKNOWN)
    ]
    return json.dumps(
        {
            "version": "1.0",
            "truncation": {
                "direction": "Right",
                "max_length": LENGTH,
                "strategy": "LongestFirst",
                "stride": 0,
            },
            "padding": {
                "strategy": {"Fixed": LENGTH},
                "direction": "Right",
                "pad_to_multiple_of": None,
                "pad_id": ids[PAD],
                "pad_type_id": 0,
                "pad_token": PAD,
            },
            "added_tokens": special,
            "normalizer": {"type": "Sequence", "normalizers": [{"type": "NFKC"}, {"type": "Lowercase"}]},
            "pre_tokenizer": {"type": "Whitespace"},
            "post_processor": None,
            "decoder": None,
            "model": {"type": "WordLevel", "vocab": ids, "unk_token": UNKNOWN},
        },
        indent=1,
    )


def encode(texts):
    """Ids (k, LENGTH) of phrases made of known words, padded."""
    ids = vocabulary()
    rows = [[ids.get(w, ids[UNKNOWN]) for w in t.split()][:LENGTH] for t in texts]
    return [r + [ids[PAD]] * (LENGTH - len(r)) for r in rows]


def class_prompts():
    """The kinds as prompts, "a bar stool", family by family."""
    return {family: [article(k) for k in kinds] for family, kinds in KINDS.items()}


def article(phrase):
    """The phrase with its article."""
    return ("an " if phrase[0] in "aeiou" else "a ") + phrase


FAMILY_NAMES = list(FAMILY_WORDS.values())
