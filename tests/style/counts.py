"""Counts of habits that may only become rarer, against tests/style/limits.toml.

usage: counts.py ROOT | counts.py --self-test | counts.py --list ROOT (each place, by count)
"""
import math
import re
import sys

import functions
import house

FRAGMENTS = {"As", "By", "Of", "Than", "Told", "What", "Where", "Which"}


def places(root):
    """For each count: the places that make it up."""
    everything = functions.functions(root, house.FLOORS)
    judged = [f for f in everything
              if not f.file.startswith("predicates/") and not f.is_macro() and "~" not in f.name]
    return {
        "many_parameters_percent": [where(f) for f in judged if len(f.parameters) > 3],
        "bool_parameters": [where(f) for f in judged if any(t in BOOLS for t in f.types())],
        "long_functions": [where(f) for f in everything if f.lines > 40],
        "doc_fragments": doc_fragments(root),
    }, len(judged)


BOOLS = {"bool", "const bool"}


def where(f):
    return f"{f.file}:{f.line}: {f.name.split('::', f.name.count('.cpp::') + f.name.count('.h::'))[-1]}"


def doc_fragments(root):
    """A block of /// lines begins as a fragment if its first word has no sentence to come."""
    found = []
    for path in house.sources(root, house.FLOORS):
        before = ""
        for number, line in enumerate(house.text_of(root, path).splitlines(), 1):
            text = re.match(r"\s*///(?!<)\s*(\w*)", line)
            if text and not re.match(r"\s*///(?!<)", before) and text.group(1) in FRAGMENTS:
                found.append(f"{path}:{number}: {line.strip()}")
            before = line
    return found


def counts(root):
    found, judged = places(root)
    numbers = {name: len(list_) for name, list_ in found.items()}
    share = 100 * numbers["many_parameters_percent"] / max(judged, 1)
    numbers["many_parameters_percent"] = math.ceil(10 * share - 1e-9) / 10
    return numbers


def check(root):
    found = []
    limits = house.limits(root)
    for name, number in counts(root).items():
        slack = 0.4 if name.endswith("_percent") else 0
        if number > limits[name]:
            found.append(f"{name} is {number}, at most {limits[name]}; counts.py --list . names the places")
        elif number < limits[name] - slack:
            found.append(f"{name} fell to {number}: run tests/style/lower_limits.py")
    return found


def self_test(planted):
    def limit(percent, bools, long, fragments):
        planted.plant("tests/style/limits.toml", f"many_parameters_percent = {percent}\n"
                      f"bool_parameters = {bools}\nlong_functions = {long}\ndoc_fragments = {fragments}\n")

    limit(0, 0, 0, 0)
    planted.plant("kernel/a.h", """
/// Whether a comment's first word begins a sentence.
/// Of no matter what the second line says.
template <class T, class U = std::pair<int, int>, class V = int, class W = int>
struct A {
  A(int a, std::map<int, int> b = {{1, 2}, {3, 4}}) noexcept : a_{a}, b_(b) {}
  A(int, int, int, int) = delete;
  std::function<void(int, int, int, int)> f;
  Triangles (*made)(int, int, int, bool);
  int a_ = f(1, 2, 3, 4);
};
void one(const A& a, int b, int c);  // void f(int, int, int, bool);
""")
    planted.plant("predicates/b.h", "int side(double a, double b, double c, double d, bool e);")
    planted.plant("kernel/c.cpp", """namespace { int kNumbers[] = {1, 2, 3}; }
void one(const A& a, int b, int c) {
  auto lambda = [](int a, int b, int c, bool d) { return d; };
}
""")
    planted.expect_clean()
    planted.plant("sims/d.cpp", "~D() { go(); }\nint four(int a, int b,\n         int c, std::vector<int> d) {}\n")
    planted.expect_fault("many_parameters_percent is 33.4", "at most 0")
    limit(33.4, 0, 0, 0)
    planted.expect_clean()
    limit(34, 0, 0, 0)
    planted.expect_fault("many_parameters_percent fell to 33.4")
    limit(33.4, 1, 0, 0)
    planted.expect_fault("bool_parameters fell to 0")
    planted.plant("sims/d.cpp", "int four(int a, int b, int c, int d) try { a = b; } catch (...) {\n"
                  + "  f();\n" * 39 + "}\nint bold(const bool yes);\nvoid A::set(bool yes = true) {}\n")
    limit(40, 0, 1, 0)
    planted.expect_fault("bool_parameters is 2")
    limit(20, 2, 0, 0)
    planted.expect_fault("long_functions is 1")
    planted.plant("surgery/e.h", "/// Of the surface.\nint x;\n/// Told of it.\n/// What it is.\nint y;  ///< of\n")
    limit(20, 2, 1, 0)
    planted.expect_fault("doc_fragments is 2")


if __name__ == "__main__":
    if sys.argv[1] == "--list":
        for name, list_ in places(sys.argv[2])[0].items():
            print(f"{name}: {len(list_)}", *list_, "", sep="\n  ")
    else:
        house.main(check, self_test)
