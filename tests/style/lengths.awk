# Finds functions above `most` lines, from the first line of their head to their closing brace.
# A brace opens a function if what stands before it, since the last ; { or }, has a parenthesis.

function start_file() {
  depth = 0; in_function = 0; head = ""; head_line = 0; in_comment = 0; raw = ""; closed = ""
}
FNR == 1 { start_file() }

# The line without comments, and without what its strings and characters hold.
function code_of(line,    out, rest, c, m) {
  out = ""
  while (length(line) > 0) {
    if (raw != "") {
      m = index(line, raw)
      if (m == 0) return out
      line = substr(line, m + length(raw)); raw = ""
    } else if (in_comment) {
      m = index(line, "*/")
      if (m == 0) return out
      line = substr(line, m + 2); in_comment = 0
    } else if (match(line, /^R"[^(]*\(/)) {
      raw = ")" substr(line, 3, RLENGTH - 3) "\""
      line = substr(line, RLENGTH + 1)
    } else if (substr(line, 1, 2) == "//") {
      return out
    } else if (substr(line, 1, 2) == "/*") {
      in_comment = 1; line = substr(line, 3)
    } else if (match(line, /^[0-9][0-9a-zA-Z]*'[0-9a-zA-Z']*/) ||  # digits in groups
               match(line, /^"([^"\\]|\\.)*"/) || match(line, /^'([^'\\]|\\.)+'/)) {
      out = out "s"; line = substr(line, RLENGTH + 1)
    } else {
      out = out substr(line, 1, 1); line = substr(line, 2)
    }
  }
  return out
}

function is_function(text) {
  if (text ~ /(^|[^a-zA-Z_])(namespace|enum)([^a-zA-Z_]|$)/) return 0
  if (text ~ /[)]/) return 1
  return text ~ /^[ ]*$/ && closed == "f"  # a constructor whose last member is set in braces
}

{
  text = code_of($0)
  if ($0 ~ /^ *#/) next
  n = length(text)
  for (i = 1; i <= n; ++i) {
    c = substr(text, i, 1)
    if (c == "{") {
      kind[++depth] = "o"
      if (!in_function && is_function(head)) {
        kind[depth] = "f"; in_function = 1
        if (!(head ~ /^[ ]*$/)) first_line = head_line
      }
      head = ""; head_line = 0
    } else if (c == "}") {
      closed = kind[depth]
      if (closed == "f") {
        in_function = 0
        if (FNR - first_line + 1 > most)
          print FILENAME ":" first_line ": a function of " FNR - first_line + 1 \
                " lines; at most " most
      }
      if (depth > 0) --depth
      head = ""; head_line = 0
    } else if (c == ";") {
      head = ""; head_line = 0; closed = ""
    } else {
      if (head_line == 0 && c != " ") head_line = FNR
      head = head c
    }
  }
  head = head " "
}
