# SPDX-License-Identifier: GPL-3.0-or-later
"""One search, from an object and a prompt to a kept shape key; the same for the panel, scripts and the
command line.

A Search is polled: the work runs on threads of the Rust library, and nothing here waits unless asked to.
"""

import time
from contextlib import suppress

import numpy as np

from ..core import engine, mesh_io, modifiers
from ..errors import Refusal
from ..outcomes import control, wordings
from ..outcomes.trial import Trial
from ..outcomes.variations import keep_variations
from ..part_boxes import parts, spanning
from ..preferences import preferences
from . import progress_pictures


class Search:
    """A running search on one object. Raises Refusal at once for anything that cannot work."""

    def __init__(
        self,
        context,
        obj,
        prompt,
        preset="standard",
        seconds=20.0,
        seed=0,
        splits="auto",
        symmetry="auto",
        keep_size="auto",
        least_scale=0.3,
        greatest_scale=3.1,
        shift_parts=False,
        variations=1,
        negative="",
        source="",
        templates="auto",
        renderer=None,
    ):
        mesh_io.deformable(obj)
        self._boxmorph = engine.library()
        guide = engine.open_guide()
        wording = wordings.wording(prompt, negative, source, templates)
        self.prompt, self.unknown = wording.prompt, wordings.checked(guide, wording)
        self.provider_note = guide.provider_note
        self.nearest = {word: guide.nearest_words(word, 1) for word in self.unknown}
        self.arrays, mesh = engine.searched(obj, context)
        #: What was asked for, by the names of SearchProperties.
        self.asked = {
            "prompt": self.prompt,
            "preset": preset,
            "seconds": seconds,
            "seed": seed,
            "splits": str(splits),
            "symmetry": symmetry,
            "keep_size": keep_size,
            "least_scale": least_scale,
            "greatest_scale": greatest_scale,
            "shift_parts": shift_parts,
            "negative": negative,
            "source": source,
            "templates": templates,
        }
        self.uid, self.object_name = obj.session_uid, obj.name
        self.shared_by = obj.data.users
        self.locked = parts.locks(obj)
        options = {
            "keep_size": None if keep_size == "auto" else keep_size,
            "scale_range": (least_scale, greatest_scale),
            "shift_parts": shift_parts,
            "variations": variations,
            "renderer": renderer or preferences().renderer,
        }
        if preset == "time":
            preset, options["seconds"] = "standard", seconds
        if self.arrays.points is not None:
            options["points"] = np.ascontiguousarray(self.arrays.points)
        try:
            if parts.are_chosen(obj):
                options["graph"] = parts.kept_graph(obj, mesh)
                options["locked"] = self.locked
            else:
                options["splits"] = "auto" if splits == "auto" else int(splits)
                options["symmetry"] = None if symmetry == "auto" else symmetry
            self._job = self._boxmorph.Job(mesh, wording, guide=guide, preset=preset, seed=seed, **options)
            self._job.start()
        except self._expected() as error:
            raise Refusal(engine.sentence(error)) from error
        self._trial = Trial(obj, self.prompt)
        self._shown_score = None
        self.progress = self._job.progress()
        self.result = None
        self.name = None
        #: The outcomes kept, `result` and its variations, and their reports.
        self.results, self.reports = [], []
        #: How far what is seen under the modifiers is from what was scored, as a share of its size.
        self._away = 0.0

    def notes(self, say=str):
        """Return sentences that the user should read before the search: unknown words, left-out modifiers; in
        English, unless `say` translates, as in the methods below.
        """
        notes = []
        if self.unknown:
            words = ", ".join(self._unknown(word, say) for word in self.unknown[:6])
            notes.append(say("The guide does not know {} and goes by the other words").format(words))
        if self.provider_note is not None:
            notes.append(engine.capitalised(self.provider_note))
        if self.arrays.left_out:
            rest = say("Searching on the rest shape, without the modifiers {}")
            notes.append(rest.format(", ".join(self.arrays.left_out)))
        if self.locked is not None:
            count = int(self.locked.any(axis=1).sum())
            locked = say("{} of {} parts is locked" if count == 1 else "{} of {} parts are locked")
            notes.append(locked.format(count, len(self.locked)))
        if self.shared_by > 1:
            shared = say("The mesh has {} users, and all of them get the shape key")
            notes.append(shared.format(self.shared_by))
        return notes

    def _unknown(self, word, say):
        """Return an unknown word in quotes, with the nearest one the guide knows."""
        if not self.nearest[word]:
            return say("“{}”").format(word)
        return say("“{word}” (nearest: “{known}”)").format(word=word, known=self.nearest[word][0])

    def poll(self):
        """Refresh `progress`; return True once the search has ended in any way."""
        self.progress = self._job.progress()
        return bool(self.progress["finished"])

    def find_object(self):
        """Return the object being deformed, or None if it is gone or no longer the mesh that was searched."""
        obj = mesh_io.object_by_uid(self.uid, self.object_name)
        if obj is None or not self._trial.fits(obj):
            return None
        return obj

    def preview(self, obj):
        """Show the best so far on `obj`, if it is better than what is shown."""
        score = self.progress["best_score"]
        if score is None or score == self._shown_score or obj.mode != "OBJECT":
            return
        best = self._job.best()
        if best is None:
            return
        self._shown_score, positions = best
        self._trial.write(obj, self.arrays.to_object(positions))

    def hide(self, obj):
        """Take the preview back for now; the next one shows again what is best."""
        self._trial.take_back(obj)
        self._shown_score = None

    def best_view(self):
        """Return a picture of the best so far, (SIZE, SIZE, 4) uint8, first row on top. There must be one."""
        return self._job.best_view(progress_pictures.SIZE)

    def keep(self, obj, context):
        """Make the finished search's result the outcome shape key of `obj`, and its variations keys beside
        it. Raises Refusal if it failed.
        """
        try:
            self._job.join()
            results = self._job.result().variations
        except self._expected() as error:
            raise Refusal(engine.sentence(error)) from error
        # All that can fail comes before the first key is kept.
        first, *others = [self._outcome(obj, context, result) for result in results]
        names = [self._trial.keep(obj, *first)]
        names += keep_variations(obj, names[0], others)
        for name in names:
            control.update_limits(obj.data.shape_keys.key_blocks[name])
        self.results, self.reports = results, [outcome[-1] for outcome in (first, *others)]
        for name, report in zip(names, self.reports, strict=True):
            report["shape_key"] = name
        self.name, self.result, self.report = names[0], results[0], self.reports[0]

    def _outcome(self, obj, context, result):
        """Return the positions, the slider limits and the report of one outcome as they are to be kept."""
        positions = result.vertices if self.arrays.points is None else result.points
        positions = self.arrays.to_object(positions)
        if not np.isfinite(positions).all():
            raise Refusal("The search ended in coordinates that are not numbers; nothing was changed")
        report = dict(result.report())
        report["object"] = self.object_name
        report["asked"] = self.asked
        report["parts_id"] = parts.identity(result.graph)
        coarse = spanning.coarse_faces(self.arrays.vertices, self.arrays.triangles, result.graph)
        report["coarse_faces"] = len(coarse)
        report["worst_shear"] = spanning.worst_shear(
            self.arrays.vertices, result.vertices, coarse, result.graph, result.scales
        )
        if self.arrays.points is not None:
            positions, away = self._under_modifiers(obj, context, positions, result)
            # JSON knows no infinity.
            report["modifiers_depart"] = away if np.isfinite(away) else None
            # Of several outcomes the farthest counts, and NaN is farther than any.
            self._away = float(np.maximum(self._away, away))
        return positions, result.slider_min, result.slider_max, report

    def _under_modifiers(self, obj, context, positions, result):
        """Return the positions corrected by what is seen under the modifiers, and how far that is from what
        was scored; NaN where it cannot be seen.
        """
        self._trial.write(obj, positions)
        rest, expected = (self.arrays.to_object(v) for v in (self.arrays.vertices, result.vertices))
        correction = modifiers.Correction(obj, context, self._trial.key(obj), rest, expected)
        try:
            correction.run(positions)
        except Refusal:
            return positions, float("nan")
        return correction.positions, correction.away

    def departures(self, obj, say=str):
        """Return sentences on what is seen of the kept outcome but was not scored: modifiers that do not
        follow it.
        """
        if not self._away > modifiers.DEPARTS:
            return []
        names = modifiers.departing(obj)
        if np.isfinite(self._away):
            how = say("up to {:.2g}% of its size").format(100 * self._away)
        else:
            how = say("in the number of its vertices")
        if len(names) == 1:
            words = say(
                "Under its modifier {names} the outcome differs from what was scored, {how}. "
                "Apply it and search again where that matters"
            )
        else:
            words = say(
                "Under its modifiers {names} the outcome differs from what was scored, {how}. "
                "Apply them and search again where that matters"
            )
        return [words.format(names=", ".join(names), how=how)]

    def shear(self, say=str):
        """Return a sentence on the long faces that span parts and how far the kept outcome shears them, in a
        list; empty where there are none.
        """
        clauses = spanning.clauses(self.report["coarse_faces"], self.report["worst_shear"], say)
        return ["; ".join([*clauses, say("Refine at Part Boundaries cuts them")])] if clauses else []

    def take_back(self, obj):
        """Restore `obj` as it was before the search. Returns whether there was anything to restore."""
        return self._trial.take_back(obj)

    def cancel(self, wait=False):
        """Ask the search to stop, which takes a generation at most; with `wait`, stay until it has."""
        self._job.cancel()
        if wait:
            with suppress(*self._expected()):
                self._job.join()

    def run(self, on_progress=None, interval=0.05):
        """Wait for the end, calling `on_progress(progress)` about once every `interval` seconds."""
        while not self.poll():
            if on_progress is not None:
                on_progress(self.progress)
            time.sleep(interval)

    def summary(self, say=str):
        """Return one line on the outcome: prompt, scores, seconds."""
        r, more = self.result, len(self.results) - 1
        scores = say("score {:.3f} → {:.3f} in {:.1f} s").format(r.score_before, r.score_after, r.seconds)
        if self.report["variations_asked"] == 1:
            return say("“{name}”: {scores}").format(name=self.name, scores=scores)
        of = self.report["variations_asked"] - 1
        if more == of:
            words = say("“{name}”: {scores}, with {found}")
        else:
            words = say(
                "“{name}”: {scores}, with {found} of {total}; no others are as good and look different"
            )
        found = say("1 variation" if more == 1 else "{} variations").format(more)
        return words.format(name=self.name, scores=scores, found=found, total=of)

    def _expected(self):
        b = self._boxmorph
        return (b.GuideError, b.RenderError, b.Cancelled, ValueError, TypeError, RuntimeError)
