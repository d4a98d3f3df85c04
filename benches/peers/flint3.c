// FLINT 3 in C on the jobs B (pieces.h) and C: the roots of polynomials in (a, b), moved to (0, oo), by Vincent, Collins and
// Akritas. For benches/peers.sh.
//
//   flint3 check FOLDER       writes the results, to be compared
//   flint3 time JOB FOLDER    prints lines JOB CASE VARIANT SECONDS, separated by tabs
//   flint3 version
//
// Cases and results are files as README.md describes them. FLINT 3 comes inside the wheel of python-flint, without headers:
// what is called is written out here. Build: gcc -O3 flint3.c libflint-*.so* libgmp-*.so*, out of that wheel.

#include "job.h"

typedef long slong;
typedef slong fmpz;
typedef fmpz fmpz_t[1];
typedef struct { fmpz num, den; } fmpq;
typedef struct { fmpz *coeffs; slong alloc, length; } fmpz_poly_struct;
typedef fmpz_poly_struct fmpz_poly_t[1];

extern const char flint_version[];
extern const char *const __gmp_version;
void fmpz_clear(fmpz *);
int fmpz_set_str(fmpz *, const char *, int);
void fmpz_one(fmpz *);
int fmpz_sgn(const fmpz *);
int fmpz_fprint(FILE *, const fmpz *);
unsigned long fmpz_fdiv_ui(const fmpz *, unsigned long);
void fmpz_mul(fmpz *, const fmpz *, const fmpz *);
void fmpz_mul_ui(fmpz *, const fmpz *, unsigned long);
void fmpz_gcd(fmpz *, const fmpz *, const fmpz *);
void fmpz_divexact(fmpz *, const fmpz *, const fmpz *);
void fmpz_poly_init(fmpz_poly_struct *);
void fmpz_poly_zero(fmpz_poly_struct *);
void fmpz_poly_one(fmpz_poly_struct *);
void fmpz_poly_swap(fmpz_poly_struct *, fmpz_poly_struct *);
void fmpz_poly_set_coeff_si(fmpz_poly_struct *, slong, slong);
void fmpz_poly_set_coeff_fmpz(fmpz_poly_struct *, slong, const fmpz *);
void fmpz_poly_neg(fmpz_poly_struct *, const fmpz_poly_struct *);
void fmpz_poly_add(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz_poly_struct *);
void fmpz_poly_mul(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz_poly_struct *);
void fmpz_poly_div(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz_poly_struct *);
int fmpz_poly_divides(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz_poly_struct *);
void fmpz_poly_gcd(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz_poly_struct *);
void fmpz_poly_content(fmpz *, const fmpz_poly_struct *);
void fmpz_poly_scalar_mul_fmpz(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz *);
void fmpz_poly_scalar_divexact_fmpz(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz *);
void fmpz_poly_taylor_shift(fmpz_poly_struct *, const fmpz_poly_struct *, const fmpz *);
void fmpz_poly_reverse(fmpz_poly_struct *, const fmpz_poly_struct *, slong);
void fmpz_poly_isolate_positive_roots(fmpq *, slong *, fmpz *, slong *, slong *, const fmpz_poly_struct *);

#include "pieces.h"

// ---- C.

enum { MOST_SLOPES = 200, MOST_ROOTS = 64 };

static int slopes;
static long from[MOST_SLOPES], to[MOST_SLOPES];
static fmpz_poly_t slope[MOST_SLOPES], moved;
static slong counts[MOST_SLOPES];
static fmpq exact[MOST_ROOTS];
static fmpz place[MOST_ROOTS];
static slong depth[MOST_ROOTS];

// Numbers as small as the ends and their powers here are kept in the words themselves: see fmpz.h.
static void count_roots(void)
{
    static fmpz power;
    for (int i = 0; i < slopes; i++) {
        slong n = slope[i]->length - 1;
        counts[i] = 0;
        if (n < 1) continue;
        fmpz a = from[i], width = to[i] - from[i], one = 1;
        fmpz_poly_taylor_shift(moved, slope[i], &a);
        fmpz_clear(&power);
        power = 1;
        for (slong c = 0; c <= n; c++) {
            fmpz_mul(moved->coeffs + c, moved->coeffs + c, &power);
            fmpz_mul(&power, &power, &width);
        }
        fmpz_poly_reverse(moved, moved, n + 1);
        fmpz_poly_taylor_shift(moved, moved, &one);
        slong exactly = 0, between = 0;
        fmpz_poly_isolate_positive_roots(exact, &exactly, place, depth, &between, moved);
        counts[i] = exactly + between;
    }
}

static void read_slopes(const char *name)
{
    static char line[1 << 16];
    fmpz coefficient = 0;
    FILE *file = open_file(name, "r");
    for (slopes = 0; slopes < MOST_SLOPES && fgets(line, sizeof line, file); slopes++) {
        from[slopes] = atol(strtok(line, " \n"));
        to[slopes] = atol(strtok(NULL, " \n"));
        fmpz_poly_zero(slope[slopes]);
        char *word;
        for (slong c = 0; (word = strtok(NULL, " \n")); c++) {
            fmpz_set_str(&coefficient, word, 10);
            fmpz_poly_set_coeff_fmpz(slope[slopes], c, &coefficient);
        }
    }
    fclose(file);
    fmpz_clear(&coefficient);
}

static void job_c(int check)
{
    static const char *families[] = {"uniform", "non-uniform"};
    for (degree = 2; degree <= 8; degree++) {
        for (int family = 0; family < 2; family++) {
            char name[64];
            snprintf(name, sizeof name, "C.%d-%s.slopes", degree, families[family]);
            read_slopes(name);
            if (!check) {
                snprintf(name, sizeof name, "k = %d, %s", degree, families[family]);
                time_job("C", name, "FLINT 3 in C, VCA", slopes / (degree + 1), count_roots);
                continue;
            }
            count_roots();
            snprintf(name, sizeof name, "C.%d-%s.flint-3", degree, families[family]);
            FILE *file = open_file(name, "w");
            for (int i = 0; i < slopes; i++) fprintf(file, i ? " %ld" : "%ld", counts[i]);
            fputc('\n', file);
            fclose(file);
        }
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "version")) {
        printf("FLINT %s with GMP %s, out of python-flint\n", flint_version, __gmp_version);
        return 0;
    }
    int check = argc == 3 && !strcmp(argv[1], "check");
    if (!check && !(argc == 4 && !strcmp(argv[1], "time"))) {
        fprintf(stderr, "usage: flint3 check FOLDER, flint3 time JOB FOLDER, or flint3 version\n");
        return 2;
    }
    folder = argv[argc - 1];
    init_pieces();
    for (int i = 0; i < MOST_SLOPES; i++) fmpz_poly_init(slope[i]);
    for (int i = 0; i < MOST_ROOTS; i++) exact[i].den = 1;
    fmpz_poly_init(moved);
    const char *job = check ? "BC" : argv[2];
    if (strchr(job, 'B')) job_b(check, "FLINT 3 in C", "flint-3");
    if (strchr(job, 'C')) job_c(check);
    return 0;
}
