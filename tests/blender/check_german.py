# SPDX-License-Identifier: MIT OR Apache-2.0
"""The interface in German, which needs a Blender with languages: the module `bpy` has none."""

#: Prints a button, a panel and a phase as they are in German, and the button once the extension is off.
_GERMAN = """
import addon_utils, bpy, importlib
NAME = 'bl_ext.user_default.boxmorph'
texts = bpy.app.translations
view = bpy.context.preferences.view
view.language = next(locale for locale in texts.locales if locale.startswith('de'))
view.use_translate_interface = True
progress = importlib.import_module(NAME + '.searching.progress')
known = dict(phase='Searching with 5 part boxes', generation=0, best_score=None, seconds_left=9.0)
said = [texts.pgettext_iface('Deform to Prompt', 'Operator'), texts.pgettext_iface('Search', 'Boxmorph')]
said += progress.progress_parts(known, texts.pgettext_iface)
addon_utils.disable(NAME)
said.append(texts.pgettext_iface('Deform to Prompt', 'Operator'))
print('GERMAN' + '|'.join(filter(None, said)))
"""


def check_german(bench, counts):
    """The extension's words are found, and are gone when it is off."""
    run = bench.run("blender", "-b", "--python-expr", _GERMAN)
    said = "GERMANZum Prompt verformen|Suche|Sucht mit 5 Boxen|noch 9 s|Deform to Prompt\n"
    counts.check(said in run.stdout, "the interface speaks German", run.stdout + run.stderr)
