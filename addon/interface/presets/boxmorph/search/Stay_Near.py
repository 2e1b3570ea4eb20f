# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

settings = bpy.context.scene.boxmorph

settings.preset = "standard"
settings.seconds = 20.0
settings.splits = "auto"
settings.symmetry = "auto"
settings.keep_size = "auto"
settings.least_scale = 0.6
settings.greatest_scale = 1.6
settings.shift_parts = False
