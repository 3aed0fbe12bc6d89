"""The environment in which somebody else's template runs: shut off, and with its steps and letters counted.

It reads no file and no other template, sees no inside of an object, and writes no markup: what stands in the template
is text. Its loops, calls, joints and what it puts out go through here, so that it ends.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from jinja2 import StrictUndefined, nodes, pass_context
from jinja2.runtime import Context, Undefined
from jinja2.sandbox import ImmutableSandboxedEnvironment, SecurityError
from markupsafe import Markup

if TYPE_CHECKING:
    from tmm_report.report.page import Page

STEPS = 20_000
LETTERS = 20_000  # of one text; of all that is put out
WHOLE = 400_000
FILTERS = ("upper", "lower", "capitalize", "trim", "length", "first", "last", "default", "select")
OF_TEXT = ("upper", "lower", "capitalize", "strip", "startswith", "endswith")
OF_LISTS = ("items", "keys", "values", "get")


class TooMuch(SecurityError):
    """More than a page could want."""


@pass_context
def _finalize(context: Context, value: Any) -> Any:
    shut = context.environment
    assert isinstance(shut, Shut) and shut.page is not None
    text = (
        value
        if isinstance(value, Markup)
        else str(value)
        if isinstance(value, Undefined)
        else shut.page.text(value)
    )
    shut.step(len(text))
    return text


class Shut(ImmutableSandboxedEnvironment):
    """Of one template. `page`: for which it is written."""

    intercepted_binops = frozenset(("+", "-", "*", "/", "//", "%", "**"))

    def __init__(self) -> None:
        super().__init__(
            undefined=StrictUndefined,
            autoescape=True,
            finalize=_finalize,
            trim_blocks=True,
            lstrip_blocks=True,
        )
        self.steps = self.letters = 0
        self.page: Page | None = None
        self.globals = {}
        self.filters = {name: self.filters[name] for name in FILTERS}

    def step(self, letters: int = 0) -> None:
        self.steps, self.letters = self.steps + 1, self.letters + letters
        if self.steps > STEPS or self.letters > WHOLE:
            raise TooMuch

    def counted(self, items: Iterable[Any]) -> Iterator[Any]:
        """What a loop goes over."""
        for item in items:
            self.step()
            yield item

    def joined(self, *parts: Any) -> Any:
        """a ~ b."""
        self.step()
        if sum(len(part) for part in map(str, parts)) > LETTERS:
            raise TooMuch
        return "".join(map(str, parts))

    def call(self, context: Any, called: Any, *args: Any, **named: Any) -> Any:
        self.step()
        return super().call(context, called, *args, **named)

    def call_binop(self, context: Any, operator: str, left: Any, right: Any) -> Any:
        """Numbers are reckoned with; texts are joined by ~."""
        for one in (left, right):
            if (
                isinstance(one, bool)
                or not isinstance(one, int | float)
                or abs(one) > 1e9
                or operator == "**"
            ):
                raise SecurityError(f"a {operator} b")
        return super().call_binop(context, operator, left, right)

    def is_safe_attribute(self, obj: Any, attr: str, value: Any) -> bool:
        if isinstance(obj, str):
            return attr in OF_TEXT
        if isinstance(obj, dict | list | tuple):
            return attr in OF_LISTS
        return super().is_safe_attribute(obj, attr, value)

    def tree_of(self, text: str, file: str) -> nodes.Template:
        """The template, whose own words are text and no markup. Raises TemplateSyntaxError."""
        tree = self.parse(text, file, file)
        for output in tree.find_all(nodes.Output):
            output.nodes = [
                nodes.Const(one.data, lineno=one.lineno) if isinstance(one, nodes.TemplateData) else one
                for one in output.nodes
            ]
        for loop in tree.find_all(nodes.For):
            loop.iter = _called("counted", [loop.iter], loop.lineno)
        _rejoin(tree)
        tree.set_environment(self)
        return tree


def _rejoin(node: nodes.Node) -> None:
    """Every a ~ b as a call that counts."""
    for name, value in node.iter_fields():
        if isinstance(value, nodes.Node):
            _rejoin(value)
            setattr(node, name, _joint(value))
        elif isinstance(value, list):
            for one in value:
                if isinstance(one, nodes.Node):
                    _rejoin(one)
            value[:] = [_joint(one) if isinstance(one, nodes.Node) else one for one in value]


def _joint(node: nodes.Node) -> nodes.Node:
    return _called("joined", node.nodes, node.lineno) if isinstance(node, nodes.Concat) else node


def _called(name: str, arguments: list[Any], line: int) -> nodes.Call:
    return nodes.Call(nodes.EnvironmentAttribute(name, lineno=line), arguments, [], None, None, lineno=line)
