# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""The results as one HTML page with a pair of bars for each."""

from __future__ import annotations

from html import escape

WIDTH = 520

PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Nacre: benchmarks</title>
<style>
body {{ font: 15px/1.45 sans-serif; max-width: 62em; margin: 2em auto; padding: 0 1em; }}
section {{ border-top: 1px solid #ccc; padding: .6em 0; }}
h2 {{ font-size: 1em; margin: 0 0 .3em; }}
p {{ margin: .3em 0; color: #444; }}
text {{ font-size: 13px; }}
</style>
<h1>Benchmarks</h1>
<p>{machine}. Cost of one job, less is better; each pair was measured in one run.</p>
{sections}
</html>
"""

SECTION = """<section><h2>{what}</h2>
<svg width="{svg_width}" height="48" role="img" aria-label="{what}">
<rect y="2" height="18" width="{ours_width:.1f}" fill="#0a7d72"/>
<text x="{ours_text:.1f}" y="16">Nacre: {ours:.4g}</text>
<rect y="26" height="18" width="{peer_width:.1f}" fill="#999"/>
<text x="{peer_text:.1f}" y="40">{peer_version}: {peer:.4g}</text>
</svg>
<p>ratio {ratio:.3g}, target {target:.3g}: {verdict}</p></section>"""

SCALING = """<section><h2>Stacks over layers, angles and threads</h2>
<img src="scaling.svg" alt="time over layers and angles, GFLOP/s over threads">
<pre>{figures}</pre></section>"""


def section(record: dict) -> str:
    scale = WIDTH / max(record["ours"], record["peer"])
    ours, peer = (max(1.0, record[key] * scale) for key in ("ours", "peer"))
    shown = {
        **record,
        "what": escape(record["what"], quote=True),
        "peer_version": escape(record["peer_version"]),
    }
    return SECTION.format(
        **shown,
        svg_width=WIDTH + 280,
        ours_width=ours,
        ours_text=ours + 8,
        peer_width=peer,
        peer_text=peer + 8,
        verdict="met" if record["met"] else "not met",
    )


def page(records: list[dict], machine: str, scaling: str | None = None) -> str:
    """@param scaling: figures that belong to `scaling.svg` beside the page."""
    sections = list(map(section, records))
    if scaling is not None:
        sections.append(SCALING.format(figures=escape(scaling)))
    return PAGE.format(machine=escape(machine), sections="\n".join(sections))
