"""A department's own template: its blocks stand in the note for those of ours, or around them.

{% block introduction %}
{{ m.p("Работа выполнена на кафедре ТММ.") }}
{{ parent() }}
{% endblock %}
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from types import TracebackType
from typing import Any

from jinja2 import Template, TemplateError, TemplateSyntaxError, nodes
from jinja2.sandbox import SecurityError
from markupsafe import Markup

from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.report.own.shut import Shut, TooMuch
from tmm_report.report.page import Page
from tmm_report.resources import data_root

MACROS = ("p", "section", "subsection", "subsubsection", "itemise", "signatures", "frontpage")
STYLES = ("head", "first", "big", "plain", "topic", "side")
_STOPS = (TemplateError, TypeError, ValueError, LookupError, AttributeError, ArithmeticError, RecursionError)


class Macros:
    """Those of our macros with which a department may lay its text out."""

    def __init__(self, macros: Any):
        def titlepage(lines: Any, signed: Any = (), foot: Any = "") -> Any:
            for line in lines:
                if strange := [one for one in str(line["style"]).split() if one not in STYLES]:
                    raise SecurityError(f"style {strange[0]}")
            return macros.titlepage(lines, signed, foot)

        self.titlepage = titlepage
        for name in MACROS:
            setattr(self, name, getattr(macros, name))


class Own:
    """The blocks of a department's template."""

    def __init__(self, text: bytes, file: str):
        """Raises ProblemError for what is no template, or has a block that the note has not."""
        self.file, self.shut = file, Shut()
        try:
            tree = self.shut.tree_of(text.decode("utf-8"), file)
            code = self.shut.compile(tree, file, file)
        except UnicodeDecodeError:
            raise self._told(Message(N_("the file is not in UTF-8"))) from None
        except TemplateSyntaxError as error:
            wrong = Message(N_("this is no template: %(what)s"), {"what": shown(error.message or "", 200)})
            raise self._told(wrong, error.lineno) from None
        except (RecursionError, MemoryError, SyntaxError, ValueError):
            raise self._told(Message(N_("the template does more than a page could want"))) from None
        for block in tree.find_all(nodes.Block):
            if block.name not in names():
                right = Message(N_("one of: %(words)s"), {"words": ", ".join(sorted(names()))})
                wrong = Message(N_("the note has no block %(name)s"), {"name": shown(block.name)})
                raise self._told(wrong, block.lineno, right)
        self.template = Template.from_code(self.shut, code, {})

    def states(self, name: str) -> bool:
        """Whether it has a block for a template of ours."""
        return block_of(name) in self.template.blocks

    def written(self, name: str, given: Mapping[str, Any], parent: Callable[[], Markup]) -> Markup:
        """The block for a template of ours; `parent` writes that. Raises ProblemError with file and line."""
        page: Page = given["page"]
        self.shut.page = page

        def listed(items: Sequence[Any], between: str = ", ") -> Markup:
            return page.listed(list(items)[:1000], str(between)[:10])

        seen = {
            "title": given["title"], "assignment": given["assignment"], "m": Macros(given["m"]),
            "parent": _once(parent), "t": lambda text: page.t(str(text)), "listed": listed,
            "contents": lambda: page.contents(), "format": page.form.name, "language": page.tr.language,
        }  # fmt: skip
        try:
            block = self.template.blocks[block_of(name)]
            return Markup("".join(block(self.template.new_context(seen))))
        except _STOPS as error:
            raise self._stopped(error) from None

    def _stopped(self, error: Exception) -> ProblemError:
        line = self._line(error.__traceback__)
        if isinstance(error, TooMuch | RecursionError):
            return self._told(Message(N_("the template does more than a page could want")), line)
        what = {"what": shown(str(error), 200)}
        if isinstance(error, SecurityError):
            return self._told(Message(N_("a template may not do this: %(what)s"), what), line)
        return self._told(Message(N_("the template stops here: %(what)s"), what), line)

    def _line(self, trace: TracebackType | None) -> int:
        """Of the template, where it stopped."""
        line = 1
        while trace is not None:
            if trace.tb_frame.f_code.co_filename == self.file:
                line = self.template.get_corresponding_lineno(trace.tb_lineno)
            trace = trace.tb_next
        return line

    def _told(self, wrong: Message, line: int = 1, right: Message | None = None) -> ProblemError:
        return ProblemError([Problem(wrong, right, file=self.file, line=line, column=1)])


def _once(write: Callable[[], Markup]) -> Callable[[], Markup]:
    """What ours writes: once, as it is numbered as it is written."""
    left = [write]

    def parent() -> Markup:
        if not left:
            raise SecurityError("parent() twice")
        return left.pop()()

    return parent


def block_of(name: str) -> str:
    """The name of the block that stands for a template: `lever_kinematics`."""
    return re.sub(r"\W", "_", name)


@cache
def names() -> frozenset[str]:
    """Of all templates of the note but those that are parts of others."""
    folder = data_root() / "templates" / "chapters"
    texts = {
        file.relative_to(folder).with_suffix("").as_posix(): file.read_text("utf-8")
        for file in folder.rglob("*.j2")
    }
    parts = {name for text in texts.values() for name in re.findall(r'"chapters/([\w/]+)\.j2"', text)}
    return frozenset(block_of(name) for name in texts.keys() - parts)
