"""One HTML page with everything in it: pictures, plots and numbers, nothing to fetch."""

import html

from page_parts import STYLE, picture, shown


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
