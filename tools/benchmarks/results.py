"""What a measurement leaves behind: its numbers as CSV files and one HTML page with all of them."""

import contextlib
import csv
import html
import math

from page_parts import facts_of, page_of, picture, shown, table_of
from processes import ProgramFailed, first_line
from renders import Candela

FAILED = 6  # the exit status where a goal is missed
MISSED = {"no", "exceeded", "missed"}  # the words of verdicts that say so


def begin(options, title, about):
    """What measurements of candela alone begin with: their folder, candela, and the results."""
    out = options.out.resolve()
    candela = Candela(options.program, out / "renders")
    return out, candela, Results(out, title, about, candela.version())


class Results:
    """Tables are printed and written as soon as they are there; finish() writes the page.
    keep() is for what of a table is there already. What an earlier run left in the folder goes."""

    latest = None  # for what stops a measurement

    def __init__(self, out, title, about, version):
        self.out, self.title = out, title
        self.parts = [f"<p>{html.escape(about)}</p>"]
        self.facts = facts_of(version, "tools/bench")
        out.mkdir(parents=True, exist_ok=True)
        self.kept = {}  # rows by name, of tables that are not told yet
        self.files = Files(out)
        Results.latest = self

    def table(self, name, title, rows, text=""):
        """`rows`: dicts of one shape; keys are the columns. Without a name no file is written."""
        if not rows:
            return self.note(f"{title}: nothing was measured.")
        if name:
            self.keep(name, rows)
            del self.kept[name]
        print(f"\n{title}\n{text_table(rows)}", flush=True)
        self.parts.append(f"<h2>{html.escape(title)}</h2>"
                          + (f"<p>{html.escape(text)}</p>" if text else "") + html_table(rows))

    def keep(self, name, rows):
        if rows:
            self.kept[name] = rows
            write_csv(self.files.add(f"{name}.csv"), rows)

    @contextlib.contextmanager
    def attempt(self, what):
        """Where a program fails within, that is told, and the rest goes on."""
        try:
            yield
        except ProgramFailed as reason:
            self.note(f"{what} is left out: {first_line(reason)}")

    def plot(self, file, caption):
        """A PNG file within the folder."""
        self.parts.append(f'<div class="plots">{picture(self.out, file, caption)}</div>')

    def note(self, sentence):
        print(sentence, flush=True)
        self.parts.append(f"<p>{html.escape(sentence)}</p>")

    def finish(self):
        self.files.add("index.html").write_text(
            page_of(self.title, self.title, self.facts, self.parts), encoding="utf-8")
        print(f"\n{self.out / 'index.html'}")

    def finish_stopped(self):
        """With what of tables is there already."""
        self.note("Stopped: the rest was not measured.")
        for name, rows in list(self.kept.items()):
            self.table(name, f"{name}, so far", rows)
        self.finish()


class Files:
    """What a measurement leaves in a folder, by a list of it there: so that what an earlier run
    left, and no other file, goes."""

    def __init__(self, folder):
        self.folder, self.list = folder, folder / ".files"
        for name in self.list.read_text().splitlines() if self.list.exists() else []:
            (folder / name).unlink(missing_ok=True)
        self.list.unlink(missing_ok=True)
        self.names = set()

    def add(self, name):
        """The file's path."""
        if name not in self.names:
            self.names.add(name)
            with self.list.open("a") as file:
                file.write(f"{name}\n")
        return self.folder / name


def status(verdicts):
    """The exit status; where nothing was measured nothing is met."""
    found = set(verdicts)
    return FAILED if MISSED & found or not found else 0


def status_of_rows(rows):
    """The same of what has no verdicts."""
    return 0 if rows else FAILED


def write_csv(path, rows):
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(rows[0])
        for row in rows:
            writer.writerow(f"{v:.6g}" if isinstance(v, float) and not math.isnan(v) else shown(v)
                            for v in row.values())


def text_table(rows):
    lines = [list(map(str, rows[0]))] + [list(map(shown, row.values())) for row in rows]
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return "\n".join("  ".join(word.ljust(width) if i == 0 else word.rjust(width)
                               for i, (word, width) in enumerate(zip(line, widths)))
                     for line in lines)


def html_table(rows):
    return table_of(map(str, rows[0]), ["".join(f"<td>{html.escape(shown(value))}</td>"
                                                for value in row.values()) for row in rows])
