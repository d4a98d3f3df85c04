// FLINT in C on the jobs A (fmpq), B (fmpz_poly: pieces.h) and C (Sturm's chain), for benches/peers.sh.
//
//   flint check FOLDER        writes the results, to be compared
//   flint time JOB FOLDER     prints lines JOB CASE VARIANT SECONDS, separated by tabs
//   flint version
//
// Cases and results are files as README.md describes them. Build: gcc -O3 flint.c -lflint -lgmp

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz.h>
#include <flint/fmpz_poly.h>
#include <gmp.h>

#include "job.h"
#include "pieces.h"

enum { MOST_POINTS = 1000, CHECKED = 25, MOST_SLOPES = 200 };

// ---- A: the triangle over fmpq, r = 1/3.

static int points;
static long point_p[MOST_POINTS], point_q[MOST_POINTS];
static fmpq *t, *rise, *fall, *value;
static fmpq_t ratio, x, carry, sum, share;

static void values_at(int point)
{
    int j = degree;
    while (point_p[point] >= knots[j + 1] * point_q[point]) j++;
    fmpq_set_si(x, point_p[point], point_q[point]);
    fmpq_one(value);
    for (int d = 1; d <= degree; d++) {
        fmpq_sub(rise + d, x, t + j + 1 - d);
        fmpq_mul(rise + d, rise + d, ratio);
        fmpq_sub(fall + d, t + j + d, x);
        fmpq_zero(carry);
        for (int c = 0; c < d; c++) {
            fmpq_add(sum, rise + d - c, fall + c + 1);
            fmpq_div(share, value + c, sum);
            fmpq_mul(sum, fall + c + 1, share);
            fmpq_add(value + c, carry, sum);
            fmpq_mul(carry, rise + d - c, share);
        }
        fmpq_set(value + d, carry);
    }
}

static void all_values(void)
{
    for (int point = 0; point < points; point++) values_at(point);
}

static void job_a(int check)
{
    static const int degrees[] = {3, 5, 10, 20};
    for (int z = 0; z < 4; z++) {
        char name[64];
        degree = degrees[z];
        snprintf(name, sizeof name, "A.%d", degree);
        FILE *file = open_file(name, "r");
        int count = read_line(file, knots, MOST_KNOTS);
        for (points = 0; points < MOST_POINTS; points++)
            if (fscanf(file, "%ld %ld", point_p + points, point_q + points) != 2) break;
        fclose(file);
        for (int i = 0; i < count; i++) fmpq_set_si(t + i, knots[i], 1);
        if (!check) {
            snprintf(name, sizeof name, "k = %d", degree);
            time_job("A", name, "FLINT in C, fmpq", points, all_values);
            continue;
        }
        snprintf(name, sizeof name, "A.%d.flint-c", degree);
        file = open_file(name, "w");
        for (int point = 0; point < points && point < CHECKED; point++) {
            values_at(point);
            for (int c = 0; c <= degree; c++) {
                if (c) fputc(' ', file);
                fmpz_fprint(file, fmpq_numref(value + c));
                fputc('/', file);
                fmpz_fprint(file, fmpq_denref(value + c));
            }
            fputc('\n', file);
        }
        fclose(file);
    }
}

// ---- C: the roots of polynomials in (a, b), moved to (0, oo), by Sturm's chain.

static int slopes;
static long from[MOST_SLOPES], to[MOST_SLOPES];
static fmpz_poly_t slope[MOST_SLOPES], moved;
static fmpz_t width, power;
static slong counts[MOST_SLOPES];

static void count_roots(void)
{
    for (int i = 0; i < slopes; i++) {
        slong n = fmpz_poly_degree(slope[i]), negative = 0;
        counts[i] = 0;
        if (n < 1) continue;
        fmpz_set_si(width, from[i]);
        fmpz_poly_taylor_shift(moved, slope[i], width);
        fmpz_set_si(width, to[i] - from[i]);
        fmpz_one(power);
        for (slong c = 0; c <= n; c++) {
            fmpz_mul(moved->coeffs + c, moved->coeffs + c, power);
            fmpz_mul(power, power, width);
        }
        fmpz_poly_reverse(moved, moved, n + 1);
        fmpz_one(width);
        fmpz_poly_taylor_shift(moved, moved, width);
        _fmpz_poly_num_real_roots_sturm(&negative, counts + i, moved->coeffs, moved->length);
    }
}

static void job_c(int check)
{
    static const char *families[] = {"uniform", "non-uniform"};
    static char line[1 << 16];
    fmpz_t coefficient;
    fmpz_init(coefficient);
    for (degree = 2; degree <= 8; degree++) {
        for (int family = 0; family < 2; family++) {
            char name[64];
            snprintf(name, sizeof name, "C.%d-%s.slopes", degree, families[family]);
            FILE *file = open_file(name, "r");
            for (slopes = 0; slopes < MOST_SLOPES && fgets(line, sizeof line, file); slopes++) {
                from[slopes] = atol(strtok(line, " \n"));
                to[slopes] = atol(strtok(NULL, " \n"));
                fmpz_poly_zero(slope[slopes]);
                char *word;
                for (slong c = 0; (word = strtok(NULL, " \n")); c++) {
                    fmpz_set_str(coefficient, word, 10);
                    fmpz_poly_set_coeff_fmpz(slope[slopes], c, coefficient);
                }
            }
            fclose(file);
            if (!check) {
                snprintf(name, sizeof name, "k = %d, %s", degree, families[family]);
                time_job("C", name, "FLINT in C, Sturm", slopes / (degree + 1), count_roots);
                continue;
            }
            count_roots();
            snprintf(name, sizeof name, "C.%d-%s.flint-c", degree, families[family]);
            file = open_file(name, "w");
            for (int i = 0; i < slopes; i++) fprintf(file, i ? " %ld" : "%ld", (long)counts[i]);
            fputc('\n', file);
            fclose(file);
        }
    }
    fmpz_clear(coefficient);
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "version")) {
        printf("FLINT %s with GMP %s, gcc %s\n", FLINT_VERSION, gmp_version, __VERSION__);
        return 0;
    }
    int check = argc == 3 && !strcmp(argv[1], "check");
    if (!check && !(argc == 4 && !strcmp(argv[1], "time"))) {
        fprintf(stderr, "usage: flint check FOLDER, flint time JOB FOLDER, or flint version\n");
        return 2;
    }
    folder = argv[argc - 1];
    t = _fmpq_vec_init(MOST_KNOTS);
    rise = _fmpq_vec_init(MOST_DEGREE + 1);
    fall = _fmpq_vec_init(MOST_DEGREE + 1);
    value = _fmpq_vec_init(MOST_DEGREE + 1);
    fmpq_init(x);
    fmpq_init(carry);
    fmpq_init(sum);
    fmpq_init(share);
    fmpq_init(ratio);
    fmpq_set_si(ratio, 1, 3);
    init_pieces();
    for (int i = 0; i < MOST_SLOPES; i++) fmpz_poly_init(slope[i]);
    fmpz_poly_init(moved);
    fmpz_init(width);
    fmpz_init(power);
    const char *job = check ? "ABC" : argv[2];
    if (strchr(job, 'A')) job_a(check);
    if (strchr(job, 'B')) job_b(check, "FLINT in C", "flint-c");
    if (strchr(job, 'C')) job_c(check);
    return 0;
}
