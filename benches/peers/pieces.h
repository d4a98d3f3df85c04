// Job B for flint.c and flint3.c, which say beforehand what FLINT is: the functions of one span as reduced P/Q in x, r = 1/3.
//
// Numerators over known products of linear factors; what these have in common with their numerators is found by one gcd a
// function, or by trying the factors.

enum { MOST_KNOTS = 64, MOST_DEGREE = 20 };
static const int PIECES[] = {3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16};

static int degree, span;
static long knots[MOST_KNOTS];
static fmpz_poly_t left[MOST_DEGREE], right[MOST_DEGREE], factor[MOST_DEGREE][MOST_DEGREE];
static fmpz_poly_t level[MOST_DEGREE], next[MOST_DEGREE], column[MOST_DEGREE], row[MOST_DEGREE];
static fmpz_poly_t P[MOST_DEGREE], Q[MOST_DEGREE], term, product, divisor;

static void init_pieces(void)
{
    for (int i = 0; i < MOST_DEGREE; i++) {
        fmpz_poly_struct *one_each[] = {left[i], right[i], level[i], next[i], column[i], row[i], P[i], Q[i]};
        for (size_t a = 0; a < sizeof one_each / sizeof *one_each; a++) fmpz_poly_init(one_each[a]);
        for (int w = 0; w < MOST_DEGREE; w++) fmpz_poly_init(factor[i][w]);
    }
    fmpz_poly_init(term);
    fmpz_poly_init(product);
    fmpz_poly_init(divisor);
}

static void linear(fmpz_poly_t p, long constant, long slope)
{
    fmpz_poly_zero(p);
    fmpz_poly_set_coeff_si(p, 1, slope);
    fmpz_poly_set_coeff_si(p, 0, constant);
}

static void numerators(void)
{
    fmpz_poly_one(level[0]);
    for (int d = 1; d <= degree; d++) {
        linear(left[d], -knots[span + 1 - d], 1);
        linear(right[d], 3 * knots[span + d], -3);
        fmpz_poly_one(column[d]);
        fmpz_poly_one(row[d]);
        // Each factor is computed once: the new ones are those on the antidiagonal s + w = d + 1.
        for (int w = 1; w <= d; w++) {
            int s = d + 1 - w;
            fmpz_poly_add(factor[s][w], left[s], right[w]);
            fmpz_poly_mul(column[w], column[w], factor[s][w]);
            fmpz_poly_mul(row[s], row[s], factor[s][w]);
        }
        for (int c = 0; c <= d; c++) {
            fmpz_poly_zero(next[c]);
            if (c < d) {
                fmpz_poly_mul(term, right[c + 1], level[c]);
                if (c > 0) fmpz_poly_mul(term, term, row[d - c + 1]);
                fmpz_poly_add(next[c], next[c], term);
            }
            if (c > 0) {
                fmpz_poly_mul(term, left[d - c + 1], level[c - 1]);
                if (c < d) fmpz_poly_mul(term, term, column[c + 1]);
                fmpz_poly_add(next[c], next[c], term);
            }
        }
        for (int c = 0; c <= d; c++) fmpz_poly_swap(level[c], next[c]);
    }
}

static void with_positive_denominator(int c)
{
    if (fmpz_sgn(Q[c]->coeffs + Q[c]->length - 1) < 0) {
        fmpz_poly_neg(P[c], P[c]);
        fmpz_poly_neg(Q[c], Q[c]);
    }
}

static void pieces_by_gcd(void)
{
    numerators();
    for (int c = 0; c <= degree; c++) {
        int rows = degree - c + 1, columns = c + 1;
        fmpz_poly_one(product);
        for (int s = 1; s <= rows; s++)
            for (int w = 1; w <= columns; w++)
                if (s < rows || w < columns) fmpz_poly_mul(product, product, factor[s][w]);
        fmpz_poly_gcd(divisor, level[c], product);
        fmpz_poly_div(P[c], level[c], divisor);
        fmpz_poly_div(Q[c], product, divisor);
        with_positive_denominator(c);
    }
}

// What follows is modulo this prime, by which 2^61 is 1.
static const unsigned long PRIME = (1UL << 61) - 1;
static unsigned long residues[MOST_DEGREE * MOST_DEGREE];

static unsigned long reduced(unsigned __int128 value)
{
    value = (value & PRIME) + (value >> 61);
    value = (value & PRIME) + (value >> 61);
    return value >= PRIME ? value - PRIME : value;
}

static void set_residues(const fmpz_poly_t p)
{
    for (long i = 0; i < p->length; i++) residues[i] = fmpz_fdiv_ui(p->coeffs + i, PRIME);
}

// Could p, which has the residues, be 0 at -a/b?
static int may_vanish(const fmpz_poly_t p, long a, long b)
{
    // For |a| and |b| below the prime.
    unsigned long x = reduced(PRIME - a), y = reduced(PRIME + b), value = 0, power = 1;
    for (long i = p->length - 1; i >= 0; i--) {
        value = reduced((unsigned __int128)value * x + (unsigned __int128)residues[i] * power);
        power = reduced((unsigned __int128)power * y);
    }
    return value == 0;
}

static int stands_in(const long *list, int length, long number)
{
    for (int i = 0; i < length; i++)
        if (list[i] == number) return 1;
    return 0;
}

static void pieces_by_factors(void)
{
    static fmpz_t contents, common;
    numerators();
    for (int c = 0; c <= degree; c++) {
        long vain[MOST_DEGREE * MOST_DEGREE];
        int rows = degree - c + 1, columns = c + 1, count = 0;
        fmpz_poly_one(product);
        fmpz_one(contents);
        fmpz_poly_swap(P[c], level[c]);
        set_residues(P[c]);
        for (int s = 1; s <= rows; s++) {
            for (int w = 1; w <= columns; w++) {
                if (s == rows && w == columns) continue;
                // The factor is constant - 2x, content (a + bx).
                long constant = 3 * knots[span + w] - knots[span + 1 - s], content = constant % 2 ? 1 : 2;
                long a = constant / content, b = -2 / content;
                fmpz_mul_ui(contents, contents, content);
                linear(term, a, b);
                if (!stands_in(vain, count, constant)) {
                    if (may_vanish(P[c], a, b) && fmpz_poly_divides(divisor, P[c], term)) {
                        fmpz_poly_swap(P[c], divisor);
                        set_residues(P[c]);
                        continue;
                    }
                    vain[count++] = constant;
                }
                fmpz_poly_mul(product, product, term);
            }
        }
        fmpz_poly_content(common, P[c]);
        fmpz_gcd(common, common, contents);
        fmpz_divexact(contents, contents, common);
        fmpz_poly_scalar_divexact_fmpz(P[c], P[c], common);
        fmpz_poly_scalar_mul_fmpz(Q[c], product, contents);
        with_positive_denominator(c);
    }
}

static void print_coefficients(FILE *file, const fmpz_poly_t p)
{
    for (long i = 0; i < p->length; i++) {
        if (i) fputc(' ', file);
        fmpz_fprint(file, p->coeffs + i);
    }
}

// The name is that of this FLINT in tables, and that of its files.
static void job_b(int check, const char *flint, const char *file_name)
{
    static const struct { const char *way, *ending; void (*run)(void); } ways[] = {
        {"gcd", "", pieces_by_gcd}, {"known factors", "-factors", pieces_by_factors}};
    for (size_t z = 0; z < sizeof PIECES / sizeof *PIECES; z++) {
        char name[64], label[64];
        long index = 0;
        degree = PIECES[z];
        snprintf(name, sizeof name, "B.%d", degree);
        FILE *file = open_file(name, "r");
        read_line(file, knots, MOST_KNOTS);
        read_line(file, &index, 1);
        fclose(file);
        span = index;
        for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
            if (!check) {
                snprintf(name, sizeof name, "k = %d", degree);
                snprintf(label, sizeof label, "%s, %s", flint, ways[way].way);
                time_job("B", name, label, 1, ways[way].run);
                continue;
            }
            ways[way].run();
            snprintf(name, sizeof name, "B.%d.%s%s", degree, file_name, ways[way].ending);
            file = open_file(name, "w");
            for (int c = 0; c <= degree; c++) {
                print_coefficients(file, P[c]);
                fputs(" / ", file);
                print_coefficients(file, Q[c]);
                fputc('\n', file);
            }
            fclose(file);
        }
    }
}
