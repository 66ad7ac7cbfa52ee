"""One HTML page with everything in it: pictures, plots and numbers, nothing to fetch."""

import base64
import html

STYLE = """
:root { color-scheme: light dark; --ink: #1b1b1f; --paper: #fbfbf8; --soft: #6a6a70; --line: #d9d9d4; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e6e3; --paper: #17181b; --soft: #9b9ba3; --line: #3a3b40; }
}
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem; color: var(--ink); background: var(--paper);
       font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.25rem; margin-top: 3rem; }
p, dl { max-width: 46rem; } code { font-size: .9em; overflow-wrap: anywhere; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; }
dt { color: var(--soft); } dd { margin: 0; }
.pictures { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(12rem, 1fr)); }
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


def shown(value):
    """Four significant digits; whole numbers whole."""
    return f"{value:d}" if isinstance(value, int) else f"{value:.4g}"


def picture(out, file, caption):
    data = base64.b64encode((out / file).read_bytes()).decode()
    text = html.escape(caption)
    return (f'<figure><img alt="{text}" src="data:image/png;base64,{data}">'
            f"<figcaption>{text}</figcaption></figure>")


def table(name, columns, rows):
    """Each number's cell says which one of figures.json it is."""
    head = "".join(f"<th>{html.escape(title)}</th>" for _, title in columns)
    lines = [f'<div class="table"><table><thead><tr><th></th>{head}</tr></thead><tbody>']
    for index, row in enumerate(rows):
        cells = "".join(f'<td data-of="{name}/rows/{index}/{key}">{shown(row[key])}</td>'
                        for key, _ in columns)
        lines.append(f"<tr><td>{html.escape(row['caption'])}</td>{cells}</tr>")
    lines.append("</tbody></table></div>")
    return "\n".join(lines)


def section(out, figure):
    parts = [f'<section id="{figure["name"]}"><h2>{html.escape(figure["title"])}</h2>']
    parts += [f"<p>{html.escape(text)}</p>" for text in figure["text"]]
    pictures = [row for row in figure["rows"] if "picture" in row]
    if pictures:
        parts.append('<div class="pictures">')
        parts += [picture(out, row["picture"], row["caption"]) for row in pictures]
        parts.append("</div>")
    parts.append('<div class="numbers">')
    if figure["rows"]:
        parts.append(table(figure["name"], figure["columns"], figure["rows"]))
    if figure["plots"]:
        parts.append('<div class="plots">')
        parts += [picture(out, file, caption) for file, caption in figure["plots"]]
        parts.append("</div>")
    return "\n".join(parts + ["</div></section>"])


def page(out, run):
    """`run`: what figures.json holds."""
    facts = "".join(f"<dt>{html.escape(key)}</dt><dd><code>{html.escape(str(run[key]))}</code></dd>"
                    for key in ("version", "command", "date", "processor", "seconds"))
    sections = "\n".join(section(out, figure) for figure in run["figures"])
    return f"""<!DOCTYPE html>
<html lang="en">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>candela: the report's figures</title><style>{STYLE}</style></head>
<body>
<h1>The report's figures, and those that it could not make</h1>
<p>candela grew from a student's report on path tracing; docs/report.md goes through it section by
section. These are its figures, rendered in one run of this program. Every number below was measured
in this run, but where a sentence says that it is the report's. Seconds are of rendering on a
machine that may have had other work; relMSE is what <code>candela compare</code> prints.</p>
<dl>{facts}</dl>
{sections}
</body></html>
"""
