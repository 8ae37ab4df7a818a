# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mutants that the sources may have, and the sources with them.

Knows of C++ only brackets and the ends of statements. What it gets wrong does not compile.
"""
import collections
import hashlib
import pathlib
import re

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
SWITCH = PACKAGE / 'test/mutants/mutant_switch.h'
# What is replaced by what, at one place of a line.
NEW = {'<': '<=', '<=': '<', '>': '>=', '>=': '>', '==': '!=', '!=': '==', '+': '-', '-': '+',
       '*': '/', '/': '*', '%': '*', '&&': '||', '||': '&&', '+=': '-=', '-=': '+=', 'min': 'max',
       'max': 'min', '++': '--', '--': '++', '!': '', 'true': 'false', 'false': 'true'}
PLACE = re.compile(r'(?<= )(?:[<>=!]=|&&|\|\||[-+]=|[-<>+*/%])(?= )|(?<=std::)(?:min|max)(?=\()'
                   r'|\+\+|--|!(?=[\w(*])|\b(?P<literal>true|false'
                   r"|(?<!\.)[0-9][0-9']*(?:\.[0-9]*)?(?:e[-+]?[0-9]+)?[uf]?)(?![\w.'])")
# Data, declarations, and what starts in the first column.
NOT_CHANGED = re.compile(r'\S|\s*(?:static|template|using|enum|case|struct|class|public|private)\b'
                         r'|.*\b(?:static_assert|constexpr|noexcept)\b')
BLANK = re.compile(r'//[^\n]*|/\*.*?\*/|R"\w*\(.*?\)\w*"|"(?:\\.|[^"\\\n])*"'
                   r"|(?<!\w)'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.S | re.M)
CONTROL = re.compile(r'\s*(?:(?:else|do)\b|case [\w:]+:|default:|(if|while|for|switch) (?=\())')
# `const Type name = `, which is before an initializer.
DECLARATION = re.compile(r'(?:^|[;{}(\n])\s*(?:const )?(?!auto\b)'
                         r'([\w:]+(?:<[\w:<>, ]+>)?) \w+ =\s*$')
Edit = collections.namedtuple('Edit', 'start end text')  # \0 stands for the number of the mutant
Mutant = collections.namedtuple('Mutant', 'key path text edit')


class Source:
    def __init__(self, content):
        # Without comments; then without texts; then a colon or sign of equality ends an expression.
        # All have the same length.
        self.text = BLANK.sub(lambda match: match.group() if match.group()[0] in '"\'R' else
                              re.sub(r'[^\n]', ' ', match.group()), content)
        self.code = BLANK.sub(lambda match: re.sub(r'[^\n]', '_', match.group()), self.text)
        self.ends = re.sub(r'::|->|[=<>!]=', '__', self.code)

    def opening(self, at, stop):
        """Behind the last of the characters before `at`, but for those in brackets."""
        depth = 0
        for i in range(at - 1, -1, -1):
            if depth == 0 and self.ends[i] in stop:
                return i + 1
            depth = max(0, depth + (self.ends[i] in ')]}') - (self.ends[i] in '([{'))
        return 0

    def closing(self, at, stop):
        """The first of the characters from `at` on, but for those in brackets; or None."""
        depth = 0
        for i in range(at, len(self.ends)):
            if depth == 0 and self.ends[i] in stop:
                return i
            depth += (self.ends[i] in '([{') - (self.ends[i] in ')]}')
            if depth < 0:
                return None
        return None

    def expression(self, at):
        start = self.opening(at, ',;{}?:=([')
        start = re.compile(r'\s*(?:(?:return|else|throw|do)\b\s*)*').match(self.code, start).end()
        end = self.closing(at, ',;}?:=)]')
        return (start, end) if end and start <= at else None

    def statement(self, first, at):
        """(start, end, is_condition) of the simple statement that `first` is in, or of the
        condition before it that `at` is in."""
        start = self.opening(first, ';{}')
        loop = self.code.rfind('for (', 0, first)
        if loop >= 0 and (self.closing(loop + 5, ')') or 0) > first:
            return None
        while match := CONTROL.match(self.code, start):
            start = match.end()
            if match.group(1):
                end = self.closing(start + 1, ')')
                if not end or at <= end:
                    is_plain = end and match.group(1) in ('if', 'while')
                    return (start + 1, end, True) if is_plain and not re.search(
                        '[=;]', self.ends[start:end]) else None
                start = end + 1
        start = re.compile(r'\s*').match(self.code, start).end()
        end = self.closing(start, ';')
        return (start, end, False) if end else None

    def is_simple(self, start, end):
        """A call or an assignment, no declaration."""
        code = self.code[start:end]
        head = re.match(r'[^(=\[{;]*', code).group()
        return (re.search(r'[(=]|\+\+|--', code) and not re.search(r'[\w>&*]\s+[\w&*]', head)
                and not re.match(r'(?:return|throw|if|for|while|switch|else|do|case|default)\b'
                                 r'|[\[{}]', code))

    def left_out(self, first):
        statement = self.statement(first, len(self.code))
        if not statement or statement[0] < first:
            return None
        start, end, _ = statement
        is_jump = self.code[start:end] in ('break', 'continue', 'return')
        if not is_jump and not self.is_simple(start, end):
            return None
        return Edit(start, end + 1, f'{{ if (!::mutantOn(\0)) {{ {self.text[start:end]}; }} }}')

    def replaced(self, start, end, new):
        """As large a part as both fit into: a statement, a condition, or else an expression. An
        expression of Eigen has another type with another operator."""
        def both(a, b):
            return self.text[a:b], self.text[a:start] + new + self.text[end:b]
        if statement := self.statement(start, start):
            a, b, is_condition = statement
            old, changed = both(a, b)
            if is_condition:
                return Edit(a, b, f'::mutantOn(\0) ? bool({changed}) : bool({old})')
            if a <= start < b and (old.startswith('return ') or self.is_simple(a, b)):
                text = f'{{ if (::mutantOn(\0)) {{ {changed}; }} else {{ {old}; }} }}'
                return Edit(a, b + 1, text)
        if not (expression := self.expression(start)):
            return None
        a, b = expression
        old, changed = both(a, b)
        declaration = DECLARATION.search(self.code[:a][-200:])
        kind = declaration.group(1) if declaration else ''
        return Edit(a, b, f'(::mutantOn(\0) ? {kind}({changed}) : {kind}({old}))')

    def edits_of(self, line, at):
        """(change, edit or None) for each change of the line that starts at `at`."""
        for match in PLACE.finditer(line):
            start, end, old = at + match.start(), at + match.end(), match.group()
            new = NEW.get(old, f'{old} + 1')
            if re.match(r'[0-9].*[.e]', old) and float(old.strip('f').replace("'", '')):
                new = f'{old} * 2'
            yield f'{old} at {match.start()}', (
                Edit(start, end, f'(::mutantOn(\0) ? {new} : {old})') if match['literal'] else
                self.replaced(start, end, new))
        if match := re.match(r' *(?:\} else )?(?:if|while) \(', line):
            start, end = at + match.end(), self.closing(at + match.end(), ')')
            if end and not re.search('[=;]', self.ends[start:end]):
                yield 'turned round', Edit(start, end,
                                           f'bool({self.text[start:end]}) != ::mutantOn(\0)')
        first = at + len(line) - len(line.lstrip())
        if self.code[:first].rstrip().endswith((';', '{', '}', ')', 'else')):
            yield 'left out', self.left_out(first)

    def changes(self):
        """(number of the line, what is changed, edit) of each change that may be made."""
        at = 0
        for number, line in enumerate(self.code.splitlines(keepends=True)):
            if line.strip() and not NOT_CHANGED.match(line):
                for change, edit in self.edits_of(line, at):
                    if edit:
                        yield number, change, edit
            at += len(line)


def candidates(room):
    """Sorted by their text, which gives the same order wherever the files are."""
    found = []
    for path in sorted((PACKAGE / 'src' / room).rglob('*.cpp')):
        content, seen = path.read_text('utf-8'), collections.Counter()
        changes = collections.defaultdict(list)
        for number, change, edit in Source(content).changes():
            changes[number].append((change, edit))
        for number, line in enumerate(content.splitlines()):
            seen[line] += 1
            for change, edit in changes[number]:
                text = f'{path.name} {seen[line]} {line.strip()} {change}'
                key = hashlib.sha256(text.encode()).hexdigest()[:16]
                found.append(Mutant(key, path.relative_to(PACKAGE), text, edit))
    return sorted(found)


def mutated(path, numbered):
    """The content of a source with all its mutants."""
    content = (PACKAGE / path).read_text('utf-8')
    for number, mutant in sorted(numbered, key=lambda item: item[1].edit.start, reverse=True):
        start, end, text = mutant.edit
        # On one line, so that the lines keep their numbers.
        text = text.replace('\n', ' ').replace('\0', str(number))
        content = content[:start] + text + '\n' * content.count('\n', start, end) + content[end:]
    return f'#include "{SWITCH}"  {content}'
