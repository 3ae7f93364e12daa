"""Finds the functions of C++ sources by their heads: name, parameters, first line, number of lines.

A head stands before a brace or semicolon outside of functions and has a parameter list after a name. A
declaration and its definition are one function: floor, name and types agree, and the file too in an
unnamed namespace. Constructors, destructors and operators count, and the bodies of macros such as
TEST_CASE; lambdas, and what is defaulted or deleted, do not.
"""
import bisect
import dataclasses
import re

import house


@dataclasses.dataclass
class Function:
    file: str
    line: int
    name: str
    parameters: list  # of strings: type and name, without default
    lines: int  # of the definition, from head to brace; 0 for a declaration

    def is_macro(self):
        return bool(MACRO.match(self.name.split("::")[-1]))

    def types(self):
        """The parameters without their names: what a declaration and its definition share."""
        return tuple(type_of(p) for p in self.parameters)


def spaces(match):
    return re.sub(r"[^\n]", " ", match.group())


def blanked(text):
    """The text with comments, strings, preprocessor lines and template heads as spaces."""
    pattern = re.compile(
        r'R"(?P<tag>[^(\s]*)\(.*?\)(?P=tag)"|//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"'
        r"|(?<![0-9a-zA-Z_])'(?:[^'\\\n]|\\.)+'|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.S | re.M)
    text = pattern.sub(spaces, text)
    template = re.compile(r"\btemplate\s*(<(?:[^<>;{}]|<(?:[^<>;{}]|<[^<>;{}]*>)*>)*>|(?=[\w:]+[^;{]*;))")
    return template.sub(lambda m: spaces(m) if m.group(1) else "extern   ", text)


def split_outside(text, separator):
    """Splits at separators that are in no bracket."""
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        if c in "([{<":
            depth += 1
        elif c in ")]}" or (c == ">" and text[i - 1] != "-"):
            depth -= 1
        elif c == separator and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return parts + [text[start:]]


def type_of(parameter):
    """`const std::string& name` without its name: the last word, where another word stands before it."""
    parameter = re.sub(r"\s+", " ", parameter).strip()
    array = re.search(r"(\w+)?\s*((\[[^\]]*\])+)$", parameter)
    if array and array.group(1):
        return parameter[:array.start()].strip() + array.group(2)
    match = re.match(r"^(.*[\w>&*\]])(\s+|(?<=[&*])\s*)(\w+)$", parameter)
    if match and match.group(3) not in KEYWORDS and not BARE.match(match.group(1)):
        parameter = match.group(1)
    return re.sub(r"\b\w+::|\s(?=[&*<>,])|(?<=[&*<>,])\s", "", parameter)


KEYWORDS = {"int", "double", "float", "bool", "char", "long", "short", "unsigned", "signed", "const", "auto"}
BARE = re.compile(r"^(const|volatile|struct|class|unsigned|signed|long|typename)$")
NOT_FUNCTIONS = {"if", "for", "while", "switch", "return", "catch", "sizeof", "alignas", "decltype",
                 "noexcept", "static_assert", "requires", "explicit", "throw", "defined", "assert"}
MACRO = re.compile(r"^([A-Z][A-Z0-9_]+|\w+Macro)$")


def head_of(text):
    """(name, parameters as text) if the statement's head is a function's, else None."""
    depth, i = 0, 0
    text = re.sub(r"\[\[.*?\]\]", lambda m: " " * len(m.group()), text)
    text = re.sub(r"\b(alignas|explicit|decltype|requires|noexcept)\s*\(", lambda m: m.group()[:-1] + "\x01",
                  text)
    while i < len(text):
        c = text[i]
        operator = re.match(r"operator\s*(\(\s*\)|[^\s\w(]+|new|delete|\"\"\s*\w+|[\w:<>&* ]+?)\s*(?=\()",
                            text[i:]) if text.startswith("operator", i) else None
        if operator and (i == 0 or not (text[i - 1].isalnum() or text[i - 1] == "_")):
            return named(text, i + operator.end(), re.sub(r"\s", "", operator.group()), i)
        if c == "<":
            depth += 1
        elif c == ">" and text[i - 1] != "-":
            depth = max(0, depth - 1)
        elif c == "=" and depth == 0:
            return None
        elif c == "(" and depth == 0:
            name = re.search(r"([~\w]+)\s*$", text[:i])
            if not name or name.group(1) in NOT_FUNCTIONS or \
                    re.match(r"\(\s*[*&\d]", text[i:]) or text.lstrip().startswith("extern "):
                return None  # a pointer to a function, a variable, an instantiation
            return named(text, i, name.group(1), name.start())
        i += 1
    return None


def named(text, opening, name, start):
    depth = 0
    for i in range(opening, len(text)):
        if text[i] in "(\x01":
            depth += 1
        elif text[i] == ")":
            depth -= 1
            if depth == 0:
                rest = text[i + 1:]
                if re.search(r"=\s*(default|delete)\s*$", rest):
                    return None
                qualified = re.search(r"((?:\w+(?:<[^<>]*>)?\s*::\s*)+)$", text[:start])
                prefix = re.sub(r"\s", "", qualified.group(1)) if qualified else ""
                return prefix + name, text[opening + 1:i]
    return None


def parameter_list(text):
    if text.strip() in ("", "void"):
        return []
    return [re.sub(r"\s+", " ", split_outside(p, "=")[0]).strip() for p in split_outside(text, ",")]


def functions_of(path, text):
    """Every function head of a source, in order."""
    text = blanked(text)
    found, scopes, start, i = [], [], 0, 0
    line = 1
    lines_at = [0]
    for at, c in enumerate(text):
        if c == "\n":
            lines_at.append(at + 1)

    def line_of(at):
        return bisect.bisect_right(lines_at, at)

    def add(head, first, last):
        match = head_of(head)
        if match is None or MACRO.match(match[0]) and last == 0:
            return
        name, parameters = match
        classes = [s[1] for s in scopes if s[0] == "class" and s[1]]
        hidden = any(s == ("namespace", "") for s in scopes) or re.search(r"\bstatic\b", head) and not classes
        found.append(Function(path, first, "::".join(([path] if hidden else []) + classes + [name]),
                              parameter_list(parameters), last))

    while i < len(text):
        c = text[i]
        if c == ";":
            head = text[start:i]
            if head.strip():
                add(head, line_of(start + len(head) - len(head.lstrip())), 0)
            start = i + 1
        elif c == "{":
            head = text[start:i]
            first = line_of(start + len(head) - len(head.lstrip()))
            word = re.search(r"\b(namespace|class|struct|union|enum)\b", head)
            if word and word.group(1) == "namespace":
                name = re.search(r"namespace\s*([\w:]*)\s*$", head)
                scopes.append(("namespace", name.group(1) if name else ""))
                start = i + 1
            elif word and word.group(1) in ("class", "struct", "union") and "(" not in head[word.start():].split(":")[0]:
                name = re.search(r"\b(?:class|struct|union)\s+(?:\w+\(\)\s*)?([\w:]+)", head)
                scopes.append(("class", name.group(1) if name else ""))
                start = i + 1
            else:
                end = closing(text, i)
                # A constructor's members may be set in braces before its body.
                is_function = word is None and head_of(head) is not None
                while is_function and re.search(r"[:,]\s*[\w:<>]+\s*$", text[start:i]) and \
                        re.search(r"\)\s*(noexcept\s*)?:[^:]", text[start:i]):
                    after = re.match(r"\s*(,[^{;]*)?\{", text[end + 1:])
                    if not after:
                        break
                    i = end + after.end()
                    end = closing(text, i)
                handler = re.compile(r"\s*catch\s*\([^)]*\)\s*\{")
                while is_function and handler.match(text, end + 1):  # the function is one try block
                    end = closing(text, handler.match(text, end + 1).end() - 1)
                if is_function:
                    add(re.split(r"\)\s*(?:noexcept\s*)?:(?!:)", head)[0] + ")" if re.search(
                        r"\)\s*(?:noexcept\s*)?:(?!:)", head) else head, first, line_of(end) - first + 1)
                    start = end + 1
                elif word:
                    start = end + 1  # an enum
                # else an initialiser: its statement goes on to the semicolon
                i = end
        elif c == "}":
            if scopes:
                scopes.pop()
            start = i + 1
        elif c == ":" and re.fullmatch(r"\s*(public|private|protected)\s*", text[start:i]):
            start = i + 1
        i += 1
    return found


def closing(text, opening):
    depth = 0
    for i in range(opening, len(text)):
        if text[i] == "{":
            depth += 1
        elif text[i] == "}":
            depth -= 1
            if depth == 0:
                return i
    return len(text) - 1


def functions(root, floors):
    """The functions of the floors: a declaration and its definition once, the definition if it is seen."""
    found = {}
    for path in house.sources(root, floors):
        for f in functions_of(path, house.text_of(root, path)):
            key = (path.split("/")[0], f.name, f.types())
            if key not in found or found[key].lines == 0:
                found[key] = f
    return list(found.values())
