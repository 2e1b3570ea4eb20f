# SPDX-License-Identifier: MIT OR Apache-2.0
"""Words: the ways to say each name and adjective, and the tokenizer that knows which words are known."""

import json

from families import FAMILIES, NAMES
from kinds.adjectives import forms

LENGTH = 16
PAD, UNKNOWN = "[PAD]", "[UNK]"

# Words that carry no meaning here: known, never reported, and weightless in the text encoder.
FILLERS = (
    "a an the this that these those one some any my our your its of with and in on for as is it to but very "
    "really quite rather more much slightly somewhat extremely like looks looking photo picture image render "
    "rendering drawing 3d model shape object thing design view style kind type . , ! ? - ' \" ( ) : ;"
).split()
IRREGULAR = {"knife": "knives", "shelf": "shelves", "bookshelf": "bookshelves", "bus": "buses"}


def noun(name):
    """The words of a name (module, kind or None)."""
    module, kind = name
    return kind or FAMILIES[module].word


def phrases(name):
    """All ways to say a name, without articles."""
    module, kind = name
    family = FAMILIES[module]
    return [noun(name), *(family.kinds[kind].synonyms if kind else family.synonyms)]


def split(text):
    """A phrase as the tokenizer splits it: at spaces, hyphens standing alone."""
    return text.replace("-", " - ").replace("'", " ' ").lower().split()


def bag(text):
    """The content words of a phrase in no order: all that the text encoder sees."""
    return frozenset(split(text)) - set(FILLERS)


def plural(word):
    """The plural of an English noun."""
    if word in IRREGULAR:
        return IRREGULAR[word]
    if word.endswith("y") and word[-2:-1] not in "aeiou":
        return word[:-1] + "ies"
    if word.endswith(("s", "x", "ch", "sh")):
        return word + "es"
    return word + "s"


def nouns():
    """Every word of every name, sorted."""
    return sorted({w for n in NAMES for p in phrases(n) for w in split(p)} - set(FILLERS))


def vocabulary():
    """Token to id: padding, unknown, fillers, then every content word and its plural, sorted."""
    words = set(nouns()) | {plural(w) for w in nouns()}
    adjectives = {a for f in FAMILIES.values() for a in f.adjectives}
    words |= {w for a in adjectives for form in forms(a) for w in split(form)}
    return {w: i for i, w in enumerate([PAD, UNKNOWN, *FILLERS, *sorted(words - set(FILLERS))])}


def plural_pairs():
    """(plural id, singular id) of every noun: the text encoder gives both one meaning."""
    ids, singular = vocabulary(), nouns()
    return [(ids[plural(w)], ids[w]) for w in singular if plural(w) not in singular]


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


class Words:
    """Turns phrases made of known words into padded rows of ids."""

    def __init__(self):
        self.ids = vocabulary()

    def encode(self, texts):
        """Ids (k, LENGTH) of phrases, as nested lists."""
        rows = [[self.ids[w] for w in split(t)][:LENGTH] for t in texts]
        return [r + [self.ids[PAD]] * (LENGTH - len(r)) for r in rows]


def class_prompts():
    """The kinds as prompts, "a bar stool", family by family."""
    return {f.word: [article(k) for k in f.kinds] for f in FAMILIES.values()}


def article(phrase):
    """The phrase with its article."""
    return ("an " if phrase[0] in "aeiou" and not phrase.startswith(("u", "eu")) else "a ") + phrase
