# SPDX-License-Identifier: MIT OR Apache-2.0
"""The interface in other languages: every message that Blender looks up has a translation, and no more."""

import ast
import inspect
import pathlib
import re
import string

import addon_blender as blender
import pytest
from addon_blender import bpy

ROOT = pathlib.Path(__file__).resolve().parents[2]

#: Called with a message to translate.
TRANSLATORS = {"iface_", "rpt_", "tip_", "say", "Refusal"}

#: Names that are the same everywhere.
NAMES = {"Boxmorph", "CUDA", "DirectML", "Core ML", "MIGraphX", "ONNX Runtime", "OpenVINO"}

LANGUAGES = blender.addon("translations").LANGUAGES
ANY = bpy.app.translations.contexts.default
OPERATOR = bpy.app.translations.contexts.operator_default


def sources():
    """The extension's source files, parsed; without the languages themselves, and without the command line,
    which is English.
    """
    paths = [path for path in (ROOT / "addon").rglob("*.py") if not path.name.startswith("command")]
    return {path.name: ast.parse(path.read_text(encoding="utf-8")) for path in paths}


def calls():
    """All calls in the sources, with the names of their files."""
    for name, tree in sources().items():
        yield from ((name, node) for node in ast.walk(tree) if isinstance(node, ast.Call))


def is_drawn(call):
    """Whether a call draws a text: a method of a layout, told from others by its argument."""
    return isinstance(call.func, ast.Attribute) and any(k.arg == "text" for k in call.keywords)


def literals(node):
    """The strings that an expression may be, where it is a string or a choice between some."""
    if isinstance(node, ast.IfExp):
        return literals(node.body) | literals(node.orelse)
    return {node.value} if isinstance(node, ast.Constant) and isinstance(node.value, str) else set()


def context_of(node):
    """The translation context that an argument names."""
    return node.value if isinstance(node, ast.Constant) else blender.addon("sidebar").CONTEXT


def messages_of_source():
    found = set()
    for _name, call in calls():
        if isinstance(call.func, ast.Name) and call.func.id in TRANSLATORS:
            context = context_of(call.args[1]) if len(call.args) > 1 else ANY
            found |= {(context, text) for text in literals(call.args[0])}
        elif is_drawn(call):
            given = {keyword.arg: keyword.value for keyword in call.keywords}
            if "translate" in given:
                continue
            context = OPERATOR if call.func.attr == "operator" else ANY
            if "text_ctxt" in given:
                context = context_of(given["text_ctxt"])
            found |= {(context, text) for text in literals(given["text"])}
    return found


def registered_classes():
    """All classes of the extension that Blender knows."""
    kinds = (bpy.types.Operator, bpy.types.Panel, bpy.types.Menu)
    kinds += (bpy.types.PropertyGroup, bpy.types.AddonPreferences)
    return [
        cls
        for kind in kinds
        for cls in kind.__subclasses__()
        if cls.__module__.startswith(blender.PACKAGE) and getattr(cls, "is_registered", True)
    ]


def messages_of_classes():
    """Labels, tooltips, and names and tooltips of properties and their choices."""
    found = set()
    for cls in registered_classes():
        rna = cls.bl_rna
        if issubclass(cls, bpy.types.Operator):
            rna = getattr(bpy.ops.boxmorph, cls.bl_idname.partition(".")[2]).get_rna_type()
            assert "\n" not in rna.description, f"the tooltip of {cls.bl_idname} has line breaks"
            found |= {(rna.translation_context, rna.name), (ANY, rna.description)}
        elif hasattr(cls, "bl_label"):
            found |= {(rna.translation_context, cls.bl_label), (ANY, getattr(cls, "bl_description", ""))}
        bases = [base for base in cls.__mro__ if base.__module__.startswith(blender.PACKAGE)]
        own = {name for base in bases for name in inspect.get_annotations(base)}
        for name in own & set(rna.properties.keys()):
            prop = rna.properties[name]
            if prop.is_hidden or prop.name == name:
                # Without a name of its own it is drawn nowhere.
                continue
            found |= {(prop.translation_context, prop.name), (ANY, prop.description)}
            if prop.type == "ENUM":
                items = [(item.name, item.description) for item in prop.enum_items]
                found |= {(prop.translation_context, name) for name, _tip in items}
                found |= {(ANY, tip) for _name, tip in items}
    return found


def messages_of_lists():
    """What is listed while Blender asks, or only on other systems."""
    editor = blender.addon("preferences_editor")
    found = {(ANY, provider[2] + ", if the ONNX Runtime library has it") for provider in editor._PROVIDERS}
    for _identifier, name, tip, number in editor._guide_items(None, None):
        if number < editor._FIRST_FOUND:
            found |= {(editor.CONTEXT, name), (ANY, tip)}
    downloads = blender.addon("guide_downloads")
    found |= {(ANY, text) for texts in downloads.PRECISIONS.values() for text in texts}
    for entry in downloads.entries():
        found |= {(ANY, entry["good_for"])} | {(ANY, p["note"]) for p in entry["precisions"].values()}
    return found


def messages_of_library():
    """The phases of a search, a download and a copy, which come from the Rust library."""
    code = "".join(
        (ROOT / "src" / "job" / name).read_text("utf-8")
        for name in ("run.rs", "progress.rs", "variations.rs")
    )
    found = re.findall(r'"([A-Z][a-z][^"]*)"', code)
    assert {"Waiting", "Finding the parts", "Searching with {} part boxes", "Done"} <= set(found)
    code = "".join((ROOT / "src" / "hub" / name).read_text("utf-8") for name in ("download.rs", "fetch.rs"))
    phases = re.findall(r'phase = "([^"]+)"', code)
    assert {"Asking the server", "Downloading"} <= set(phases)
    code = (ROOT / "src" / "python" / "copy.rs").read_text("utf-8")
    phases += re.findall(r'Step::\w+ => "([^"]+)"', code)
    assert {"Reading the guide", "Comparing them"} <= set(phases)
    return {(ANY, phase) for phase in found + phases}


def messages():
    """Return all (context, message) that have to be translated."""
    found = messages_of_source() | messages_of_classes() | messages_of_lists() | messages_of_library()
    return {(c, m) for c, m in found if re.search("[A-Za-z]{2}|“", m) and m not in NAMES}


#: Gathered before other tests use the panels: Blender gives that of the presets another label.
MESSAGES = messages()


def fields(template):
    """The fields of a template, each with its format, in any order."""
    return sorted(
        (name, spec) for _text, name, spec, _conv in string.Formatter().parse(template) if name is not None
    )


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_message_is_translated(language):
    missing = MESSAGES - LANGUAGES[language].keys()
    lines = [f'    ({context!r}, {message!r}): "",' for context, message in sorted(missing)]
    assert not missing, f"addon/translations/{language}.py has no entries for:\n" + "\n".join(lines)


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_translation_is_left_over(language):
    dead = LANGUAGES[language].keys() - MESSAGES
    assert not dead, "\n".join(f"{key!r} is in addon/translations/{language}.py only" for key in sorted(dead))


@pytest.mark.parametrize("language", LANGUAGES)
def test_templates_have_the_same_fields(language):
    for (_context, message), translation in LANGUAGES[language].items():
        assert fields(message) == fields(translation), message
        assert translation.strip() == translation != ""


def test_no_text_is_put_together_untranslated():
    for name, call in calls():
        function = call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
        given = {keyword.arg: keyword.value for keyword in call.keywords}
        texts = [given["text"]] if is_drawn(call) and "translate" not in given else []
        if function == "Refusal":
            texts = call.args[:1]
        elif function == "report" and len(call.args) > 1:
            assert not literals(call.args[1]), f"{name}:{call.lineno} reports a text: give it to rpt_()"
            texts = call.args[1:2]
        assert not any(map(has_words, texts)), (
            f"{name}:{call.lineno} puts words into an f-string: use a template"
        )


def has_words(node):
    """Whether an expression is an f-string with words in it."""
    parts = node.values if isinstance(node, ast.JoinedStr) else ()
    return any(isinstance(part, ast.Constant) and re.search("[A-Za-z]{2}", part.value) for part in parts)
