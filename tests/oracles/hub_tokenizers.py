# SPDX-License-Identifier: MIT OR Apache-2.0
"""Tokenizers of CLIP, SigLIP and SigLIP 2 as the hub lays them out, learnt from Python's own manual.

Only the vocabulary is another than in the real ones: normalizers, pre-tokenizers, special tokens and lengths
are those of `transformers`' classes. Needs transformers, tokenizers and sentencepiece.
"""

import io
import json
import pydoc_data.topics
import random
import string

import sentencepiece
import tokenizers
import transformers
from sentencepiece import sentencepiece_model_pb2
from tokenizers import Regex, models, normalizers, pre_tokenizers, processors

WORDS = r"<\|startoftext\|>|<\|endoftext\|>|'s|'t|'re|'ve|'m|'ll|'d|[\p{L}]+|[\p{N}]|[^\s\p{L}\p{N}]+"
EXTRA = [
    "a bar stool. a coffee table, an armchair; a fighter jet! a wooden chair with four legs?",
    "ein Stuhl für große Räume; une chaise élégante; силла стул кресло; 木の椅子 一把椅子; כיסא كرسي",
] * 50


def corpus():
    return [*pydoc_data.topics.topics.values(), *EXTRA]


def clip(folder):
    """`CLIPTokenizer`: byte-level BPE with `</w>` at the end of words. Returns it and their number."""
    byte_level = pre_tokenizers.ByteLevel(add_prefix_space=False)
    split = pre_tokenizers.Split(Regex(WORDS), "removed", invert=True)
    learner = tokenizers.Tokenizer(models.BPE(end_of_word_suffix="</w>"))
    learner.normalizer = normalizers.Lowercase()
    learner.pre_tokenizer = pre_tokenizers.Sequence([split, byte_level])
    trainer = tokenizers.trainers.BpeTrainer(
        vocab_size=6000, end_of_word_suffix="</w>", show_progress=False, special_tokens=[]
    )
    learner.train_from_iterator(corpus(), trainer)
    merges = [tuple(pair) for pair in json.loads(learner.to_str())["model"]["merges"]]
    letters = sorted(byte_level.alphabet())
    tokens = [*letters, *(letter + "</w>" for letter in letters), *(a + b for a, b in merges)]
    vocabulary = {token: number for number, token in enumerate(dict.fromkeys(tokens))}
    for token in ("<|startoftext|>", "<|endoftext|>"):
        vocabulary[token] = len(vocabulary)
    made = transformers.CLIPTokenizer(vocab=vocabulary, merges=merges, model_max_length=77)
    made.save_pretrained(folder)
    return made, len(vocabulary)


def siglip(folder, canonical=True):
    """`SiglipTokenizer`, which cuts by SentencePiece itself, and the tokenizer.json that exports bring.

    With `canonical` that file also makes lower case and drops punctuation, as the class does.
    """
    model = io.BytesIO()
    sentencepiece.SentencePieceTrainer.train(
        sentence_iterator=iter(line for text in corpus() for line in text.lower().splitlines()),
        model_writer=model,
        vocab_size=3000,
        character_coverage=0.9995,
        pad_id=0,
        eos_id=1,
        unk_id=2,
        bos_id=-1,
        minloglevel=2,
    )
    (folder / "spiece.model").write_bytes(model.getvalue())
    proto = sentencepiece_model_pb2.ModelProto.FromString(model.getvalue())
    whole = tokenizers.Tokenizer(models.Unigram([(p.piece, p.score) for p in proto.pieces], unk_id=2))
    steps = [normalizers.Precompiled(proto.normalizer_spec.precompiled_charsmap)]
    steps += [normalizers.Replace(Regex(" {2,}"), " "), normalizers.Strip()]
    if canonical:
        punctuation = "[" + "".join("\\" + c for c in string.punctuation) + "]"
        lower = [normalizers.Lowercase(), normalizers.Replace(Regex(punctuation), "")]
        steps = [*lower, normalizers.Replace(Regex(r"\s+"), " "), normalizers.Strip(), *steps]
    whole.normalizer = normalizers.Sequence(steps)
    whole.pre_tokenizer = pre_tokenizers.Metaspace(replacement="▁", prepend_scheme="always")
    whole.post_processor = processors.TemplateProcessing(single="$A </s>", special_tokens=[("</s>", 1)])
    whole.add_special_tokens(["</s>", "<unk>"])
    whole.save(str(folder / "tokenizer.json"))
    settings = {"tokenizer_class": "SiglipTokenizer", "model_max_length": 64, "padding_side": "right"}
    settings |= {"pad_token": "</s>", "eos_token": "</s>", "unk_token": "<unk>", "do_lower_case": True}
    (folder / "tokenizer_config.json").write_text(json.dumps(settings))
    return transformers.SiglipTokenizer(str(folder / "spiece.model")), len(proto.pieces)


def siglip2(folder):
    """`Siglip2Tokenizer`: Gemma's BPE, spaces as ▁, unknown letters as bytes, `<eos>` behind."""
    special = ["<pad>", "<eos>", "<bos>", "<unk>", "<mask>"]
    learner = tokenizers.Tokenizer(models.BPE(unk_token="<unk>", byte_fallback=True, fuse_unk=True))
    learner.normalizer = normalizers.Replace(" ", "▁")
    learner.pre_tokenizer = pre_tokenizers.Split("▁", "merged_with_next")
    bytes_ = [f"<0x{number:02X}>" for number in range(256)]
    trainer = tokenizers.trainers.BpeTrainer(
        vocab_size=5000, show_progress=False, special_tokens=[*special, *bytes_], limit_alphabet=300
    )
    learner.train_from_iterator((text.lower() for text in corpus()), trainer)
    learnt = json.loads(learner.to_str())["model"]
    made = transformers.Siglip2Tokenizer(
        vocab=learnt["vocab"], merges=[tuple(pair) for pair in learnt["merges"]], model_max_length=64
    )
    made.padding_side = "right"
    made.backend_tokenizer.post_processor = processors.TemplateProcessing(
        single="$A <eos>", special_tokens=[("<eos>", 1)]
    )
    made.save_pretrained(folder)
    # The hub's file is Gemma's own and makes no lower case; the class does.
    content = json.loads((folder / "tokenizer.json").read_text())
    content["normalizer"] = {"type": "Replace", "pattern": {"String": " "}, "content": "▁"}
    (folder / "tokenizer.json").write_text(json.dumps(content))
    return made, len(learnt["vocab"])


ALPHABETS = [
    string.ascii_lowercase + "    ",
    string.ascii_letters + string.digits + string.punctuation + "   ",
    "äöüßéèêñçøåæœ ÄÖÜẞÉÈÊÑÇØÅÆŒİıſΣσς ",
    "абвгдеёжз АБВГДЕЁЖЗ αβγδε ΑΒΓΔΕ ",
    "一把椅子木の机テーブルおいす의자책상 ",
    "כיסאשולחן كرسيطاولة ",
    "🪑🛋️🚀👨‍👩‍👧‍👦🇩🇪👍🏽 a",
    "e\u0301a\u0308o\u0302n\u0303 \u200b\u200d\u200c\ufeff\u00a0\u2003\u3000x",
    "\t\n\r\v\f \x1c\x1fab",
    "\x01\x02\x07\x08\x1b\x7f ab",
    "ﬁﬂ①②½²㎏ｆｕｌｌ Ａ１",
]
PHRASES = [
    "a bar stool",
    "A Bar Stool",
    "a photo of a chair.",
    "an armchair, red & blue (1990's)",
    "it's a table; we'll see, they've said I'm",
    "a fighter jet with 2 engines and 10,000 rivets",
]


def strings(count=1000, seed=0):
    """Texts as users and nobody would type them: empty, overlong, of many scripts, with blanks everywhere."""
    generator = random.Random(seed)
    texts = ["", " ", "  ", "\n", "a", "é", "🪑", "!", *PHRASES, "a chair " * 60, "ab" * 600, "🪑" * 200]
    while len(texts) < count:
        kind = generator.randrange(4)
        if kind == 0:
            alphabet = generator.choice(ALPHABETS)
            text = "".join(generator.choices(alphabet, k=generator.randrange(1, 80)))
        elif kind == 1:
            text = " ".join("".join(generator.choices(a, k=5)) for a in generator.choices(ALPHABETS, k=5))
        elif kind == 2:
            blank = generator.choice([" ", "  ", "   ", "\t", "\n "])
            text = blank.join(generator.choice(PHRASES).split())
            text = generator.choice(["", " ", "   "]) + text + generator.choice(["", " ", "  "])
        else:
            codes = (generator.randrange(1, 0x2FFFF) for _ in range(generator.randrange(1, 12)))
            text = "".join(chr(code) for code in codes if not 0xD800 <= code <= 0xDFFF)
        texts.append(text)
    return texts[:count]
