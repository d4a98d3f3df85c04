\\ PARI/GP on the jobs A, B, C and E, for benches/peers.sh, which calls check(FOLDER) or jobs(JOB, FOLDER).
\\
\\ check writes the results, to be compared; jobs prints lines JOB CASE VARIANT SECONDS, separated by tabs.
\\ Cases and results are files as README.md describes them.

BUDGET = 100; \\ milliseconds
CHECKED = 25;
FAMILIES = ["uniform", "non-uniform"];

integers(line) = [eval(word) | word <- strsplit(line, " ")];
join(words) = strjoin([Str(word) | word <- words], " ");
save(folder, name, lines) =
{
  my(file = fileopen(Str(folder, "/", name), "w"));
  foreach(lines, line, filewrite(file, line));
  fileclose(file);
};

\\ Runs the job until the time is over, and prints the seconds for each of its units. As the clock counts
\\ milliseconds only, it is asked after more and more runs.
timed(job, case, variant, units, run) =
{
  my(runs = 0, more = 1, start = getwalltime(), elapsed = 0);
  run();
  start = getwalltime();
  while (elapsed < BUDGET,
    for (i = 1, more, run());
    runs += more; if (elapsed < BUDGET/4, more *= 2);
    elapsed = getwalltime() - start);
  print(job, "\t", case, "\t", variant, "\t", strprintf("%.12f", elapsed/1000./runs/units));
};

\\ The triangle as it is written, over whatever x and r are: numbers, or variables.
triangle(x, t, r, j, k) =
{
  my(row = vector(k+1), rise = vector(k), fall = vector(k), carry, share);
  row[1] = 1;
  for (d = 1, k,
    rise[d] = r*(x - t[j+1-d]); fall[d] = t[j+d] - x; carry = 0;
    for (c = 1, d,
      share = row[c]/(rise[d-c+1] + fall[c]);
      row[c] = carry + fall[c]*share;
      carry = rise[d-c+1]*share);
    row[d+1] = carry);
  row;
};

\\ A: here and in what follows t[1] is t_0.
span(t, k, x) = { my(j = k+1); while (x >= t[j+1], j++); j };
points(folder, k) =
{
  my(lines = readstr(Str(folder, "/A.", k)));
  [integers(lines[1]), apply(line -> my(p = integers(line)); p[1]/p[2], lines[2..-1])];
};
job_a(folder, check) =
{
  foreach([3, 5, 10, 20], k,
    my(c = points(folder, k), t = c[1], X = c[2], r = 1/3, at, n);
    at = (x -> triangle(x, t, r, span(t, k, x), k));
    if (check,
      save(folder, Str("A.", k, ".pari"),
        [strjoin([Str(numerator(g), "/", denominator(g)) | g <- at(x)], " ") | x <- X[1..CHECKED]]),
      n = #X;
      timed("A", Str("k = ", k), "PARI, t_FRAC", n, () -> for (i = 1, n, at(X[i])))));
};

\\ Numerators over known products of the linear factors rise[s] + fall[w], without a division.
numerators(rise, fall, k) =
{
  my(level = [1], column = vector(k), row = vector(k), e);
  for (d = 1, k,
    column[d] = row[d] = 1;
    for (w = 1, d, e = rise[d+1-w] + fall[w]; column[w] *= e; row[d+1-w] *= e);
    level = vector(d+1, n, my(c = n-1, sum = 0, part);
      if (c < d, part = fall[c+1]*level[c+1]; if (c > 0, part *= row[d-c+1]); sum += part);
      if (c > 0, part = rise[d-c+1]*level[c]; if (c < d, part *= column[c+1]); sum += part);
      sum));
  level;
};
denominators(rise, fall, k) =
{
  vector(k+1, n, my(q = 1);
    for (s = 1, k-n+2, for (w = 1, n, if (s < k-n+2 || w < n, q *= rise[s] + fall[w])));
    q);
};
without_gcd(t, p, q, j, k) =
{
  my(rise = vector(k, s, p*('x - t[j+1-s])), fall = vector(k, w, q*(t[j+w] - 'x)));
  [numerators(rise, fall, k), denominators(rise, fall, k)];
};
with_gcd(t, p, q, j, k) =
{
  my(all = without_gcd(t, p, q, j, k), g);
  vector(k+1, n, g = gcd(all[1][n], all[2][n]); [all[1][n]/g, all[2][n]/g]);
};

span_case(folder, job, k) =
{
  my(lines = readstr(Str(folder, "/", job, ".", k)));
  [integers(lines[1]), eval(lines[2]) + 1];
};

\\ P / Q by rising powers of x, with coprime integers, the last of Q positive.
normal(P, Q) =
{
  my(c = content(concat(Vec(P), Vec(Q))) * sign(pollead(Q)));
  Str(join(Vecrev(P/c)), " / ", join(Vecrev(Q/c)));
};
job_b(folder, check) =
{
  foreach([3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16], k,
    my(c = span_case(folder, "B", k), t = c[1], j = c[2]);
    if (check,
      save(folder, Str("B.", k, ".pari"), [normal(f[1], f[2]) | f <- with_gcd(t, 1, 3, j, k)]);
      save(folder, Str("B.", k, ".pari-quotients"),
        [normal(numerator(f), denominator(f)) | f <- triangle('x, t, 1/3, j, k)]),
      timed("B", Str("k = ", k), "PARI, without fractions", 1, () -> with_gcd(t, 1, 3, j, k));
      timed("B", Str("k = ", k), "PARI, t_RFRAC", 1, () -> triangle('x, t, 1/3, j, k))));
};

\\ C: [a, b, polynomial] of each span.
slopes(folder, k, family) =
{
  apply(line -> my(n = integers(line)); [n[1], n[2], Polrev(n[3..-1])],
    readstr(Str(folder, "/C.", k, "-", family, ".slopes")));
};
count_roots(S) = [if (poldegree(f[3]) < 1, 0, polsturm(f[3], [f[1], f[2]])) | f <- S];
job_c(folder, check) =
{
  for (k = 2, 8, foreach(FAMILIES, family,
    my(S = slopes(folder, k, family), label = Str("k = ", k, ", ", family));
    if (check,
      save(folder, Str("C.", k, "-", family, ".pari"), [join(count_roots(S))]),
      timed("C", label, "PARI, polsturm", #S/(k+1), () -> count_roots(S)))));
};

\\ E: the terms c x^a r^b as c:a:b.
terms(f) =
{
  my(list = List(), p);
  for (a = 0, poldegree(f, 'x), p = polcoef(f, a, 'x);
    for (b = 0, poldegree(p, 'r), if (polcoef(p, b, 'r), listput(list, Str(polcoef(p, b, 'r), ":", a, ":", b)))));
  join(list);
};
job_e(folder, check) =
{
  for (k = 3, 5,
    my(c = span_case(folder, "E", k), t = c[1], j = c[2], label = Str("k = ", k));
    if (check,
      save(folder, Str("E.", k, ".pari"), [Str(terms(f[1]), " / ", terms(f[2])) | f <- with_gcd(t, 'r, 1, j, k)]);
      save(folder, Str("E.", k, ".pari-quotients"),
        [Str(terms(numerator(f)), " / ", terms(denominator(f))) | f <- triangle('x, t, 'r, j, k)]),
      timed("E", label, "PARI, t_RFRAC", 1, () -> triangle('x, t, 'r, j, k));
      timed("E", label, "PARI, not reduced", 1, () -> without_gcd(t, 'r, 1, j, k))));
};

'x; 'r; \\ x before r
check(folder) = { job_a(folder, 1); job_b(folder, 1); job_c(folder, 1); job_e(folder, 1) };
jobs(job, folder) =
{
  if (job == "A", job_a(folder, 0), job == "B", job_b(folder, 0), job == "C", job_c(folder, 0),
    job == "E", job_e(folder, 0));
};
