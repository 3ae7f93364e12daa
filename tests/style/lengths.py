"""Files of at most 400 lines, functions of at most 60."""
import functions
import house

MOST_FILE, MOST_FUNCTION = 400, 60


def check(root):
    found = []
    for path in house.sources(root, house.FLOORS + ["tests"]):
        text = house.text_of(root, path)
        lines = len(text.splitlines())
        if lines > MOST_FILE:
            found.append(f"{path}:1: {lines} lines; at most {MOST_FILE}")
        found += [f"{path}:{f.line}: a function of {f.lines} lines; at most {MOST_FUNCTION}"
                  for f in functions.functions_of(path, text) if f.lines > MOST_FUNCTION]
    return found


def self_test(planted):
    def lines(count):
        return "  f();  // } not a brace\n" * count

    planted.plant("kernel/a.cpp", "namespace a {\nstruct B {\n  B(int c)\n      : c_{c} {\n" + lines(57)
                  + '  }\n};\nconst char* d = R"(}\n{)";\nvoid g() {\n' + lines(58) + "}\n" + lines(200)
                  + "}  // namespace a\n")
    planted.expect_clean()
    planted.plant("kernel/b.cpp", "void g(int a,\n       int b) {\nif (a) { f(\"}\"); }\n" + lines(57) + "}\n")
    planted.expect_fault("kernel/b.cpp:1: a function of 61 lines")
    planted.plant("kernel/c.cpp", "struct B {\n  B(int c)\n      : c_{c} {\n" + lines(58) + "  }\n};\n")
    planted.expect_fault("kernel/c.cpp:2: a function of 61 lines")
    planted.plant("tests/d.test.cpp", "TEST_CASE(\"a\") {\n" + lines(60) + "}\n")
    planted.expect_fault("tests/d.test.cpp:1: a function of 62 lines")
    planted.plant("sims/e.cpp", lines(401))
    planted.expect_fault("sims/e.cpp:1: 401 lines")


if __name__ == "__main__":
    house.main(check, self_test)
