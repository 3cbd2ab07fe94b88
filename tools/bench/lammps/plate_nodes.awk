# The plate of in.plate: nodes in atoms.data, exclusions that make the crack in crack.in, and in whole.txt the share of each node's
# bonds that the crack leaves. Set dx, the spacing, and recipe:
#   exact   no pair sees the other whose bond crosses the crack; nodes near a tip have a type each for that
#   strips  nodes above the crack do not see those below, as LAMMPS' users do it; bonds to nodes beside the strips stay
function abs(x) { return x < 0 ? -x : x }
function at(k) { return dx * (k - 0.5 * side + 0.5) }
function column(node) { return (node - 1) % side }
function row(node) { return int((node - 1) / side) }

function is_cut(i, j, k, l,    x, y, u, v) {
  x = at(i); y = at(j); u = at(k); v = at(l)
  if (y * v > 0) return 0
  return recipe == "strips" ? abs(x) < crack && abs(u) < crack : abs((x * v - u * y) / (v - y)) <= crack * (1 + 1e-9)
}

function is_near(i, j, k, l) { return dx * dx * ((k - i) ^ 2 + (l - j) ^ 2) <= horizon ^ 2 }

function whole(i, j,    k, l, all, left) {
  if (abs(at(j)) > horizon || abs(at(i)) > crack + horizon) return 1
  for (k = i - reach; k <= i + reach; k++) for (l = j - reach; l <= j + reach; l++) {
    if (!is_near(i, j, k, l) || k == i && l == j) continue
    all++
    left += !is_cut(i, j, k, l)
  }
  return left / all
}

# 1: not at the crack; 2 above, 3 below; a type of its own from 4 on.
function type_of(node,    x, y) {
  x = abs(at(column(node))); y = at(row(node))
  if (abs(y) > horizon || x > crack + horizon || recipe == "strips" && x > crack) return 1
  if (recipe == "strips" || x < crack - horizon) return y > 0 ? 2 : 3
  alone[++types] = node
  return types
}

function exclude(p, q) { print "neigh_modify exclude type", p, q > "crack.in" }

BEGIN {
  crack = 0.005; horizon = 0.0016
  side = 2 * int(0.025 / dx + 1e-9); nodes = side * side; reach = int(horizon / dx); types = 3
  for (n = 1; n <= nodes; n++) type[n] = type_of(n)
  printf "# the plate\n\n%d atoms\n%d atom types\n", nodes, types > "atoms.data"
  printf "-0.029 0.029 xlo xhi\n-0.029 0.029 ylo yhi\n0 %.9f zlo zhi\n\nAtoms # peri\n\n", dx > "atoms.data"
  print nodes > "whole.txt"
  for (n = 1; n <= nodes; n++) {
    printf "%d %d %.12g 8000 %.9g %.9g %.9g\n", n, type[n], dx ^ 3, at(column(n)), at(row(n)), 0.5 * dx > "atoms.data"
    printf "%d %.17g\n", n, whole(column(n), row(n)) > "whole.txt"
  }
  exclude(2, 3)
  for (p = 4; p <= types; p++) {
    i = column(alone[p]); j = row(alone[p])
    exclude(at(j) > 0 ? 3 : 2, p)
    for (q = p + 1; q <= types; q++) {
      k = column(alone[q]); l = row(alone[q])
      if (is_near(i, j, k, l) && is_cut(i, j, k, l)) exclude(p, q)
    }
  }
}
