"""What the script says, in the language of the note."""

from __future__ import annotations

from tmm_report.i18n import Translator
from tmm_report.problems import N_

WORDS = {
    "play": N_("Play"),
    "pause": N_("Pause"),
    "back": N_("Position before"),
    "next": N_("Next position"),
    "place": N_("Position of the mechanism"),
    "position": N_("Position"),
    "speed": N_("Speed"),
    "paths": N_("Trajectories"),
    "velocities": N_("Velocities"),
    "accelerations": N_("Accelerations"),
    "forces": N_("Forces"),
    "values": N_("Values"),
    "scheme": N_("Moving scheme of the mechanism: drag a link, or use the arrow keys"),
    "contents": N_("Contents"),
    "light": N_("Light or dark"),
    "return": N_("Back to where I was"),
    "copy": N_("Copy the table"),
    "copied": N_("Copied"),
    "comma": N_("Decimal comma"),
    "full": N_("Fill the window"),
    "close": N_("Close"),
    "formula": N_("The formula"),
    "begins": N_("It begins with:"),
    "starts": N_("It starts with:"),
    "likewise": N_("The note writes out other positions; this is found in the same way."),
    "fold": N_("Show or hide the mechanism"),
}


def words(tr: Translator) -> dict[str, str]:
    return {name: tr.gettext(text) for name, text in WORDS.items()}
