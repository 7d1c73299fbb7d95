# HexFeatureWB - LGPL-2.1-or-later
"""Everything with a window: commands, task panels, what is drawn in the 3D view. Holds no geometry: it shows what the core made."""
