# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the state that each message of a step shows, in the order of events."""
from sequences_judge import wrong_boxes


class Path:
    """The states since the last step. The first one has been shown already."""

    def __init__(self, state):
        self.states = [state]
        self._required = {0}  # places of states that must be shown, because they are news

    def arrive(self, state, is_must=True):
        if is_must and state.is_news(self.states[-1]):
            self._required.add(len(self.states))
        self.states.append(state)

    def match(self, messages):
        """The state that each ~boxes shows. No message goes back, and no news is left out."""
        place, shown, states = 0, {0}, []
        for message in messages:
            wrongs = [wrong_boxes(message, state) for state in self.states[place:]]
            fits = [place + i for i, wrong in enumerate(wrongs) if not wrong]
            if not fits:
                raise AssertionError("~boxes shows none of %d states: %s" % (
                    len(wrongs), "\n  or: ".join(dict.fromkeys(wrongs))))
            place = next((fit for fit in fits if fit not in shown), fits[0])
            shown.add(place)
            states.append(self.states[place])
        is_limited = any(state.model.parameters["max_rate"] for state in self.states)
        if not self._required <= shown and not is_limited:
            raise AssertionError("no message for %d of %d states that are news" % (
                len(self._required - shown), len(self._required)))
        return states
