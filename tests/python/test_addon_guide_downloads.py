# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides downloaded from within Blender, from a server on this machine: operators, timer, command line."""

import pathlib
import shutil
import time

import addon_blender as blender
import boxmorph
import pytest
from addon_blender import bpy
from hub_server import MINI, HubServer

ID = "clip-vit-base-patch32"

downloads = blender.addon("guide_downloads")
section = blender.addon("guide_download")


@pytest.fixture
def hub():
    with HubServer() as server:
        yield server


@pytest.fixture
def prefs(tmp_path, monkeypatch, hub):
    """Preferences with an empty guides folder and the server's address; Blender allows online access."""
    for name in ("HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY", "HF_ENDPOINT", "HF_HUB_CACHE"):
        monkeypatch.delenv(name, raising=False)
        monkeypatch.delenv(name.lower(), raising=False)
    monkeypatch.setenv("HF_HOME", str(tmp_path / "hf"))
    monkeypatch.setattr(downloads, "bpy", Online(True))
    prefs = blender.preferences()
    prefs.guides_folder, prefs.hub_endpoint = str(tmp_path / "guides"), hub.url
    downloads._presences.clear()
    yield prefs
    downloads.stop()
    prefs.guide_folder = prefs.guides_folder = prefs.hub_endpoint = ""
    prefs.guide_elsewhere = False


class Online:
    """`bpy`, in a Blender that allows online access or does not."""

    def __init__(self, access, override=False, background=True):
        self.app = App(access, override, background)

    def __getattr__(self, name):
        return getattr(bpy, name)


class App:
    def __init__(self, *answers):
        self.online_access, self.online_access_override, self.background = answers

    def __getattr__(self, name):
        return getattr(bpy.app, name)


def download(precision="fp32", **options):
    return bpy.ops.boxmorph.download_guide(guide=ID, precision=precision, **options)


def command(*arguments):
    return blender.addon("command").main([str(argument) for argument in arguments])


def tick_until_the_end():
    """What Blender's timer does, which never fires in the module."""
    while downloads._tick() is not None:
        time.sleep(0.02)


def test_a_downloaded_guide_is_chosen_and_deforms(prefs):
    assert download() == {"FINISHED"}
    assert pathlib.Path(prefs.guide_folder) == pathlib.Path(prefs.guides_folder) / f"{ID}-fp32"
    assert prefs.guide == f"FOUND:{ID}-fp32"
    guide, why = blender.addon("engine").known_guide()
    assert why is None and guide.name == f"{ID}-fp32", "it was not opened"
    blender.empty_scene()
    obj = blender.chair()
    blender.deform()
    (report,) = blender.addon("shape_key").records(obj.data).values()
    assert report["guide"]["name"] == f"{ID}-fp32"


def test_the_timer_follows_the_download(prefs, hub):
    hub.rate = 4_000_000
    downloads.start(ID, "fp32")
    downloads.watch()
    assert bpy.app.timers.is_registered(downloads._tick)
    said = set()
    while downloads._tick() is not None:
        said.add(section.progress_text(downloads.state.progress))
        time.sleep(0.02)
    bpy.app.timers.unregister(downloads._tick)
    assert len([text for text in said if "of 4.0 MB" in text]) > 3
    assert downloads.state.download is None and prefs.guide == f"FOUND:{ID}-fp32"


@pytest.mark.parametrize(
    ("answers", "sentence"),
    [
        ((False, False, False), "Online access is off. Allow it in the preferences, under System"),
        ((False, True, False), "Blender was started offline"),
        ((False, False, True), "Start it with --online-mode"),
    ],
)
def test_nothing_is_asked_of_the_network_unless_blender_allows_it(prefs, hub, monkeypatch, answers, sentence):
    monkeypatch.setattr(downloads, "bpy", Online(*answers))
    assert sentence in str(downloads.online_refusal())
    assert not bpy.ops.boxmorph.download_guide.poll()
    with pytest.raises(RuntimeError):
        download()
    with pytest.raises(blender.addon("errors").Refusal, match=sentence.partition(".")[0]):
        downloads.start(ID, "fp32")
    assert command("guides", "--get", ID) == 1
    assert hub.log == [] and not pathlib.Path(prefs.guides_folder).exists()


def test_this_module_of_blender_is_offline():
    # What the fixture pretends otherwise.
    assert not bpy.app.online_access


def test_a_failure_is_kept_to_be_shown(prefs, hub):
    hub.statuses = {"/onnx/": [404] * 9}
    with pytest.raises(RuntimeError, match=r"has no onnx/vision_model\.onnx"):
        download()
    assert "has no onnx/vision_model.onnx" in str(downloads.state.refusal)
    assert "has no onnx" in blender.addon("errors").told[-1]
    assert prefs.guide == "EMBEDDED"
    hub.statuses = {}
    download()
    assert downloads.state.refusal is None


def test_it_is_cancelled_resumed_and_removed(prefs, hub):
    hub.rate = 1_000_000
    downloads.start(ID, "fp32")
    with pytest.raises(blender.addon("errors").Refusal, match="is being downloaded"):
        downloads.start(ID, "fp32")
    assert not bpy.ops.boxmorph.download_guide.poll() and not bpy.ops.boxmorph.remove_guide.poll()
    while not downloads.poll() and downloads.state.progress["bytes"] < 400_000:
        time.sleep(0.02)
    assert bpy.ops.boxmorph.cancel_guide() == {"FINISHED"}
    tick_until_the_end()
    assert prefs.guide == "EMBEDDED" and downloads.state.refusal is None
    there = downloads.presence(ID, "fp32")
    assert there["state"] == "partial" and 0 < there["bytes"] < there["total"]
    assert section._said("fp32", there).startswith("Full (fp32): 0.")
    assert blender.addon("guides").found() == [], "half a guide is offered"
    hub.rate = None
    assert download(resume=True) == {"FINISHED"}
    assert [span for *_, span in hub.log if span]
    assert downloads.presence(ID, "fp32")["state"] == "present"
    assert bpy.ops.boxmorph.remove_guide(guide=ID, precision="fp32") == {"FINISHED"}
    assert prefs.guide == "EMBEDDED" and blender.addon("guides").found() == []


def test_a_guide_that_is_here_can_be_chosen_again(prefs):
    with pytest.raises(RuntimeError, match="is not here"):
        bpy.ops.boxmorph.use_guide(guide=ID, precision="fp32")
    download()
    prefs.guide = "EMBEDDED"
    assert bpy.ops.boxmorph.use_guide(guide=ID, precision="fp32") == {"FINISHED"}
    assert prefs.guide == f"FOUND:{ID}-fp32"


def test_disabling_the_extension_stops_a_download(prefs, hub):
    hub.rate = 200_000
    downloads.start(ID, "fp32")
    downloads.watch()
    begin = time.monotonic()
    downloads.stop()
    assert time.monotonic() - begin < 5 and downloads.state.download is None
    assert not bpy.app.timers.is_registered(downloads._tick)


def test_every_precision_has_a_name_for_people():
    for entry in downloads.entries():
        assert set(entry["precisions"]) <= set(downloads.PRECISIONS)


def test_the_command_lists_what_there_is(prefs, capfd):
    download()
    (pathlib.Path(prefs.guides_folder) / "mine").mkdir()
    capfd.readouterr()
    assert command("guides") == 0
    lines = capfd.readouterr().out.splitlines()
    assert f"{ID}: CLIP ViT-B/32, MIT. The paper's guide; the one to begin with" in lines
    assert "    fp32: about 608 MB, downloaded" in lines
    assert any(line.endswith("unverified") for line in lines)
    assert any(line.startswith("mine: in ") for line in lines)


def test_the_command_downloads_and_removes(prefs, hub, capfd):
    prefs.hub_endpoint = "http://127.0.0.1:9"
    hub.rate = 4_000_000
    assert command("guides", "--get", ID, "--endpoint", hub.url) == 0
    out = capfd.readouterr().out
    assert "licence MIT" in out and "of 4.0 MB" in out and "sees images of 64 pixels" in out
    assert prefs.guide == "EMBEDDED", "the command changed the preferences"
    assert command("guides", "--remove", ID) == 0
    assert blender.addon("guides").found() == []


def test_the_command_refuses_what_there_is_not(prefs, capfd):
    assert command("guides", "--get", "none") == 1
    assert "There is no guide “none” to download. Choose clip-vit-base-patch32" in capfd.readouterr().err
    assert command("guides", "--get", "mobileclip-s0", "--precision", "int8") == 1
    assert "does not come in int8" in capfd.readouterr().err


@pytest.mark.parametrize("kind", ["name", "folder", "embedded"])
def test_deform_takes_a_guide_by_name_or_folder(prefs, tmp_path, kind, capfd):
    download()
    named = {"name": f"{ID}-fp32", "folder": MINI, "embedded": "embedded"}[kind]
    blender.empty_scene()
    blender.chair()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "chair.blend"))
    before = prefs.guide_folder
    options = ("--guide", named, "--splits", "2", "--report", tmp_path / "report.json")
    assert command("deform", "--prompt", "a bar stool", *options) == 0
    guide = {"name": f"{ID}-fp32", "folder": "mini", "embedded": "mini"}[kind]
    assert f'"name": "{guide}"' in (tmp_path / "report.json").read_text()
    assert prefs.guide_folder == before
    assert command("deform", "--prompt", "a bar stool", "--guide", "none") == 1
    assert "There is no guide “none”. Choose embedded, clip-vit-base-patch32-fp32" in capfd.readouterr().err


@pytest.fixture
def snapshot(tmp_path, prefs):
    """A guide in the hub's cache, as another program may have left it: exact and in eight bits."""
    toys = pytest.importorskip("toy_guides", reason="the module onnx, which makes it, is not installed here")
    folder = tmp_path / "hf" / "hub" / "models--Xenova--clip-vit-base-patch32" / "snapshots" / ("0" * 40)
    toys.TinyViT(place="onnx").write(folder)
    networks = folder / "onnx"
    boxmorph.Guide.quantize(folder)
    (networks / "vision_model_int8.onnx").rename(networks / "vision_model_quantized.onnx")
    shutil.copy(networks / "text_model.onnx", networks / "text_model_quantized.onnx")
    return folder


def test_of_several_precisions_in_the_cache_the_chosen_one_is_opened_and_told(snapshot):
    engine, editor = blender.addon("engine"), blender.addon("preferences_editor")
    assert bpy.ops.boxmorph.use_guide(guide=ID, precision="int8") == {"FINISHED"}
    guide = engine.open_guide()
    assert (guide.name, guide.precision) == ("Xenova/clip-vit-base-patch32", "int8")
    assert ", int8, sha256" in editor.guide_lines()[1][0]
    assert section._is_chosen("int8") and not section._is_chosen("fp32")
    blender.empty_scene()
    obj = blender.chair()
    blender.deform()
    (report,) = blender.addon("shape_key").records(obj.data).values()
    assert report["guide"]["precision"] == "int8"
    bpy.ops.boxmorph.use_guide(guide=ID, precision="fp32")
    assert engine.open_guide().precision == "fp32"
    assert section._is_chosen("fp32") and not section._is_chosen("int8")


def test_a_copy_of_a_guide_in_the_cache_is_called_by_its_repository(snapshot, prefs):
    bpy.ops.boxmorph.use_guide(guide=ID, precision="fp32")
    bpy.ops.boxmorph.quantize_guide()
    assert pathlib.Path(prefs.guide_folder).name == "clip-vit-base-patch32-8bit"
    assert blender.addon("engine").open_guide().precision == "int8"
