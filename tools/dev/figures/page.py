"""The report's figures as one HTML page: pictures, plots and numbers."""

import html

from page_parts import page_of, picture, shown, table_of

ABOUT = """\
<p>candela grew from a student's report on path tracing; docs/report.md goes through it section by
section. These are its figures, rendered in one run of this program. Every number below was measured
in this run, but where a sentence says that it is the report's. Seconds are of rendering on a
machine that may have had other work; relMSE is what <code>candela compare</code> prints.</p>"""


def numbers(place, columns, rows):
    """A table. Each number's cell says which one below `place` of the page's JSON file it is."""
    def cells(index, row):
        return f"<td>{html.escape(row['caption'])}</td>" + "".join(
            f'<td data-of="{place}/{index}/{key}">{shown(row[key])}</td>' for key, _ in columns)

    return table_of(["", *(title for _, title in columns)],
                    [cells(index, row) for index, row in enumerate(rows)])


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
        parts.append(numbers(f"{figure['name']}/rows", figure["columns"], figure["rows"]))
    if figure["plots"]:
        parts.append('<div class="plots">')
        parts += [picture(out, file, caption) for file, caption in figure["plots"]]
        parts.append("</div>")
    return "\n".join(parts + ["</div></section>"])


def page(out, record):
    """`record`: what figures.json holds."""
    facts = {key: value for key, value in record.items() if key != "figures"}
    return page_of("the report's figures", "The report's figures, and those that it could not make",
                   facts, [section(out, figure) for figure in record["figures"]], [ABOUT])
