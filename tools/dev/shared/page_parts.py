"""Pages of results and what they are made of: everything within the file, nothing to fetch."""

import base64
import datetime
import html
import math
import os
import pathlib
import shlex
import sys

STYLE = """
:root { color-scheme: light dark;
        --ink: #1b1b1f; --paper: #fbfbf8; --soft: #6a6a70; --line: #d9d9d4; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e6e3; --paper: #17181b; --soft: #9b9ba3; --line: #3a3b40; }
}
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem;
       color: var(--ink); background: var(--paper);
       font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.25rem; margin-top: 3rem; }
p, dl { max-width: 46rem; } code { font-size: .9em; overflow-wrap: anywhere; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; }
dt { color: var(--soft); } dd { margin: 0; }
.pictures { display: grid; gap: 1rem;
            grid-template-columns: repeat(auto-fill, minmax(12rem, 1fr)); }
.numbers { display: flex; flex-wrap: wrap; gap: 1rem 3rem; align-items: flex-start; }
.plots { flex: 1 1 24rem; max-width: 36rem; }
figure { margin: 1rem 0 0; } figcaption { color: var(--soft); font-size: .85rem; }
img { width: 100%; height: auto; display: block; } .pictures img { image-rendering: pixelated; }
.plots img { border-radius: 4px; }
.table { overflow-x: auto; margin-top: 1rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
th, td { padding: .15rem .8rem .15rem 0; text-align: right; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
"""


def page_of(title, heading, facts, parts, about=(), style=""):
    """A whole page: what is said `about` it, the facts, and its parts, all as HTML."""
    terms = "".join(f"<dt>{html.escape(key)}</dt><dd><code>{html.escape(str(value))}</code></dd>"
                    for key, value in facts.items())
    body = "\n".join([f"<h1>{html.escape(heading)}</h1>", *about, f"<dl>{terms}</dl>", *parts])
    return f"""<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>candela: {html.escape(title)}</title><style>{STYLE}{style}</style></head>
<body>
{body}
</body></html>
"""


def facts_of(version, tool):
    """Of this run, as a page tells them. `version`: candela's."""
    now = datetime.datetime.now(datetime.timezone.utc)
    return {"version": version, "command": shlex.join([tool, *sys.argv[1:]]),
            "date": now.strftime("%Y-%m-%d %H:%M UTC"), "processor": processor()}


def table_of(titles, rows):
    """`rows`: the HTML of each one's cells."""
    head = "".join(f"<th>{html.escape(title)}</th>" for title in titles)
    body = "\n".join(f"<tr>{cells}</tr>" for cells in rows)
    return (f'<div class="table"><table><thead><tr>{head}</tr></thead><tbody>\n{body}\n'
            "</tbody></table></div>")


def shown(value):
    """Four significant digits; whole numbers and words whole; nothing where there is no value."""
    if isinstance(value, float):
        return "" if math.isnan(value) else f"{value:.4g}"
    return "" if value is None else str(value)


def picture(out, file, caption):
    data = base64.b64encode((out / file).read_bytes()).decode()
    text = html.escape(caption)
    return (f'<figure><img alt="{text}" src="data:image/png;base64,{data}">'
            f"<figcaption>{text}</figcaption></figure>")


def processor():
    name = next((line.split(":", 1)[1].strip()
                 for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
                 if line.startswith("model name")), "unknown")
    return f"{name}, {len(os.sched_getaffinity(0))} processors"
