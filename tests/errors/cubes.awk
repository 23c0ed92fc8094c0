# Unit cubes as a mesh for Gmsh 2.2: a line of the input is the corner of a
# cube with the least coordinates, three digits from 0 to 8.
function node(i, j, k,   key) {
  key = i " " j " " k
  if (!(key in number)) { number[key] = ++nodes; place[nodes] = key }
  return number[key]
}
{
  cube[++cubes] = cubes " 5 2 1 1 " \
    node($1, $2, $3) " " node($1 + 1, $2, $3) " " \
    node($1 + 1, $2 + 1, $3) " " node($1, $2 + 1, $3) " " \
    node($1, $2, $3 + 1) " " node($1 + 1, $2, $3 + 1) " " \
    node($1 + 1, $2 + 1, $3 + 1) " " node($1, $2 + 1, $3 + 1)
}
END {
  print "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" nodes
  for (n = 1; n <= nodes; ++n) print n " " place[n]
  print "$EndNodes\n$Elements\n" cubes
  for (c = 1; c <= cubes; ++c) print cube[c]
  print "$EndElements"
}
