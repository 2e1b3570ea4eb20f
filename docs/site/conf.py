# SPDX-License-Identifier: MIT OR Apache-2.0
"""How Sphinx makes a site of the Markdown files: `make site`.

The pages lie where they are read on a code host too; the folder that Sphinx reads is the repository. They
stand in the navigation in the order in which the README, and then the pages, link to each other; a page that
none links to comes last.
"""

import re
import shutil
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("README.md", "docs/*.md", "guides/*/README.md", "training/README.md", "C*.md")

project = "Boxmorph"
author = "The Boxmorph developers"
copyright = f"2026, {author}"
root_doc = "README"
include_patterns = list(PAGES)
exclude_patterns = [".*", "build", "demo", "dist", "target", "training/.venv", "training/out"]

extensions = ["myst_parser"]
# Links to headings work as on a code host.
myst_heading_anchors = 4

html_theme = "furo"
html_title = project
html_copy_source = False
html_show_sphinx = False
html_use_index = False


def pages_in_reading_order():
    """Return all pages but the README, as Sphinx names them."""
    every = [path for pattern in PAGES for path in sorted(ROOT.glob(pattern))]
    ordered = [ROOT / "README.md"]
    for page in ordered:
        links = re.findall(r"\]\(([^)\s#:]+\.md)", page.read_text(encoding="utf-8"))
        found = dict.fromkeys((page.parent / link).resolve() for link in links)
        ordered += [path for path in found if path in every and path not in ordered]
    ordered += [path for path in every if path not in ordered]
    return [path.relative_to(ROOT).with_suffix("").as_posix() for path in ordered[1:]]


def add_navigation(_app, name, source):
    """Append the table of pages to the README, as it is read."""
    if name != root_doc:
        return
    pages = pages_in_reading_order()
    guide = [page for page in pages if page.startswith("docs/")]
    project_pages = [page for page in pages if page not in guide]
    for caption, chapter in (("User guide", guide), ("Project", project_pages)):
        table = "\n".join(chapter)
        source[0] += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{table}\n```\n"


def copy_front_page(app, exception):
    """The README is also the page that a server shows first."""
    if exception is None:
        shutil.copy(Path(app.outdir, "README.html"), Path(app.outdir, "index.html"))


def setup(app):
    """Called by Sphinx."""
    app.connect("source-read", add_navigation)
    app.connect("build-finished", copy_front_page)
