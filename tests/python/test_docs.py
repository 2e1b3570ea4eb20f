# SPDX-License-Identifier: MIT OR Apache-2.0
"""Pages of the documents: what they link to and show is there, and the site made of them is whole."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(
    [ROOT / "README.md", *ROOT.glob("docs/*.md"), ROOT / "guides/mini/README.md", ROOT / "training/README.md"]
)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_and_pictures_are_there(page):
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    targets = re.findall(r"\]\(([^)\s]+)\)", text)
    for target in targets:
        if not target.startswith(("http://", "https://", "#")):
            assert (page.parent / target.partition("#")[0]).exists(), f"{target} is missing"


def test_every_page_can_be_reached_from_the_readme():
    reached, waiting = set(), [ROOT / "README.md"]
    while waiting:
        page = waiting.pop()
        if page in reached:
            continue
        reached.add(page)
        links = re.findall(r"\]\(([^)\s#]+\.md)", page.read_text(encoding="utf-8"))
        waiting += [(page.parent / link).resolve() for link in links if "://" not in link]
    assert set(ROOT.glob("docs/*.md")) <= reached, sorted(set(ROOT.glob("docs/*.md")) - reached)


def build_site(root, folder):
    """Build the site of the pages below `root` as `make site` does; return the CompletedProcess."""
    pytest.importorskip("furo", reason="Sphinx and its theme are not installed; run `make site`")
    options = ("--fail-on-warning", "--keep-going", "--quiet", "-c", root / "docs/site")
    command = [sys.executable, "-m", "sphinx", *options, "-d", folder / "doctrees", root, folder / "site"]
    return subprocess.run(command, text=True, capture_output=True)


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The folder of the built site."""
    folder = tmp_path_factory.mktemp("site")
    run = build_site(ROOT, folder)
    assert run.returncode == 0, run.stderr
    return folder / "site"


def test_every_page_is_in_the_navigation_of_every_page(site):
    wanted = {page.relative_to(ROOT).with_suffix(".html") for page in PAGES if page != ROOT / "README.md"}
    for page in (site / "index.html", site / "docs/parts.html", site / "guides/mini/README.html"):
        navigation = page.read_text(encoding="utf-8").partition('class="sidebar-tree"')[2]
        links = re.findall(r'class="reference internal" href="([^"#]+)"', navigation.partition("</aside>")[0])
        reached = {(page.parent / link).resolve().relative_to(site) for link in links}
        # A page's own entry is "#".
        assert wanted - {page.relative_to(site)} <= reached, page


def test_the_first_chapters_are_in_the_order_of_the_readme(site):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    first = [link.removesuffix(".md") + ".html" for link in re.findall(r"\]\((docs/[^)]+\.md)", text)]
    navigation = (site / "index.html").read_text(encoding="utf-8").partition('class="sidebar-tree"')[2]
    places = [navigation.index(f'href="{link}"') for link in first]
    assert places == sorted(places)


def test_the_site_needs_no_network(site):
    for page in site.rglob("*.html"):
        loaded = re.findall(
            r"<(?:link|script|img)\b[^>]*?(?:href|src)=\"([^\"]+)", page.read_text(encoding="utf-8")
        )
        assert not [target for target in loaded if "//" in target], page


def test_every_page_can_be_searched(site):
    text = (site / "searchindex.js").read_text(encoding="utf-8")
    index = json.loads(text.removeprefix("Search.setIndex(").removesuffix(")"))
    assert {str(page.relative_to(ROOT).with_suffix("")) for page in PAGES} <= set(index["docnames"])
    assert "spectrum" in index["terms"]


@pytest.mark.parametrize("fault", ["[x](none.md)", "[x](parts.md#none)", "![x](images/none.png)"])
def test_the_site_is_not_built_with_a_fault(tmp_path, fault):
    for page in PAGES:
        copy = tmp_path / "pages" / page.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(page, copy)
    shutil.copytree(ROOT / "docs", tmp_path / "pages" / "docs", dirs_exist_ok=True)
    with (tmp_path / "pages" / "docs" / "guides.md").open("a", encoding="utf-8") as page:
        page.write(f"\n{fault}\n")
    run = build_site(tmp_path / "pages", tmp_path)
    assert run.returncode != 0 and "docs/guides.md" in run.stderr and "none" in run.stderr
