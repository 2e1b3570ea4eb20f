# SPDX-License-Identifier: GPL-3.0-or-later
import bpy

settings = bpy.context.scene.boxmorph

settings.preset = "draft"
settings.seconds = 20.0
settings.splits = "auto"
settings.symmetry = "auto"
settings.keep_size = "auto"
settings.least_scale = 0.3
settings.greatest_scale = 3.1
settings.shift_parts = False
