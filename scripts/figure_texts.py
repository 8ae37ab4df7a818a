# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures in README.md and doc/*.md, and where they come from.

doc/figures.json has the measured values, by key. doc/figures.txt has each sentence and table row
that carries figures, with {KEY} or {KEY:FORMAT} in their place. FORMAT is Python's; without one a
number below 1 has two decimals, one below 10 has one, and larger ones have none.
"""
import json
import pathlib
import re

HEADING = '== '
PLACE = re.compile(r'\{([\w/.]+)(?::([^}]*))?\}')
NUMBER = re.compile(r'(?<![\w.])\d[\d,.]*(?:e-?\d+)?')
UNIT = re.compile(r'\s+(ns|µs|ms|s|seconds|minutes|bytes|kB|KiB|MB|%|times)(?![\w])')


def to_text(value, form):
    """A value as it stands in a text."""
    if isinstance(value, str):
        return format(value, form or '')
    if form:
        text = format(value, form)
        return text.lstrip('-') if not text.strip('-0.') else text  # no minus zero
    if isinstance(value, int):
        return format(value, ',')
    if value < 0.995:
        return '%.2f' % value
    return '%.1f' % value if value < 9.95 else format(value, ',.0f')


class Sentence:
    """A sentence or table row with places for figures."""

    def __init__(self, page, text):
        self.page, self.text = page, text
        literals = PLACE.split(text)[::3]
        self.places = PLACE.findall(text)
        # A cell is on one line, a sentence may be broken anywhere. A number ends before a stop.
        figure = r'([^|\n]*?)' if text.startswith('|') else r'(-?[\d.,]*\d|[^|]{1,60}?)'
        self._pattern = re.compile(figure.join(
            r'\s+'.join(re.escape(word) for word in re.split(r'\s+', literal))
            for literal in literals))

    def find(self, page_text):
        """Its only match in the page. Raises LookupError if there is none, or more than one."""
        matches = list(self._pattern.finditer(page_text))
        if len(matches) != 1:
            raise LookupError('%s: %d times in the page, but should be there once: %s' % (
                self.page, len(matches), self.text))
        return matches[0]

    def figures(self, values):
        """The figures as they must stand in the text."""
        missing = [key for key, _ in self.places if key not in values]
        if missing:
            raise LookupError('%s: doc/figures.json lacks %s, for: %s' % (
                self.page, ', '.join(missing), self.text))
        return [to_text(values[key], form) for key, form in self.places]

    def updated(self, page_text, values):
        """The page with the right figures."""
        match = self.find(page_text)
        for i, figure in reversed(list(enumerate(self.figures(values), 1))):
            if ' '.join(match.group(i).split()) != figure:
                page_text = page_text[:match.start(i)] + figure + page_text[match.end(i):]
        return page_text


def read_sentences(package):
    """Every sentence of doc/figures.txt."""
    page, result = None, []
    for line in package.joinpath('doc', 'figures.txt').read_text('utf-8').splitlines():
        if line.startswith(HEADING):
            page = line[len(HEADING):]
        elif line and not line.startswith('#'):
            result.append(Sentence(page, line))
    return result


def read_values(path):
    """{key: value} of a file of figures."""
    return json.loads(path.read_text('utf-8'))['figures']


def pages_of(package):
    """{name: text} of all pages."""
    paths = [package / 'README.md', *sorted((package / 'doc').glob('*.md'))]
    return {str(path.relative_to(package)): path.read_text('utf-8') for path in paths}


def differences(package, values):
    """One line per figure that is not what was measured."""
    pages, result = pages_of(package), []
    for sentence in read_sentences(package):
        try:
            match = sentence.find(pages[sentence.page])
            found = [' '.join(figure.split()) for figure in match.groups()]
            wanted = sentence.figures(values)
        except LookupError as error:
            result.append(str(error))
            continue
        result += ['%s: %s must be %s (%s) in: %s' % (sentence.page, old, new, key, sentence.text)
                   for old, new, (key, _) in zip(found, wanted, sentence.places) if old != new]
    return result


def write(package, values):
    """Puts the values into the pages. All or nothing: raises LookupError before it writes."""
    pages = pages_of(package)
    for sentence in read_sentences(package):
        pages[sentence.page] = sentence.updated(pages[sentence.page], values)
    for name, text in pages.items():
        pathlib.Path(package, name).write_text(text, 'utf-8')


def without_code(text):
    """Code is replaced by blanks, so that positions stay."""
    def blank(match):
        return re.sub(r'\S', ' ', match.group(0))
    text = re.sub(r'^```.*?^```$', blank, text, flags=re.DOTALL | re.MULTILINE)
    return re.sub(r'`[^`\n]+`', blank, text)


def unexplained(package, name, in_rows):
    """One line per figure of the page that is in no sentence of doc/figures.txt: a number with a
    unit, and with `in_rows` each number in a table."""
    text = pages_of(package)[name]
    spans = []
    for sentence in read_sentences(package):
        if sentence.page == name:
            match = sentence.find(text)
            spans.append((match.start(), match.end()))
    result, code_free = [], without_code(text)
    for match in NUMBER.finditer(code_free):
        line = code_free[code_free.rfind('\n', 0, match.start()) + 1:].split('\n', 1)[0]
        is_figure = UNIT.match(code_free, match.end()) or in_rows and line.startswith('|')
        is_known = any(start <= match.start() < end for start, end in spans)
        if is_figure and not is_known:
            result.append('%s: doc/figures.txt does not explain %s in: %s' % (
                name, match.group(0), line.strip()))
    return result
