//! The words: what first-order formulas can't say. Type and sentence stand here, where they are read and printed; the decider
//! stands in `meaning::words`, in a `match` without a wildcard, so that a new word asks for both.

/// What a word may be said of, and what it gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    /// An integer.
    Int,
    /// A number.
    Real,
    /// A function of one variable: `G[i]`.
    Function,
    /// A term with its variable, and an interval where it matters: `C(x), x in [t[0], t[m]]`.
    Expression,
    /// Control values by their name.
    Coefficients,
    /// True or false.
    Truth,
}

/// One entry for each word: the name in Rust, as written, what it is said of, what it gives, and how it is read aloud, with
/// {0}, {1} for what it is said of.
macro_rules! words {
    ($($(#[$doc:meta])* $word:ident $name:literal ($($sort:ident),*) -> $gives:ident $says:literal;)*) => {
        /// What formulas can't say.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Word { $($(#[$doc])* $word,)* }

        impl Word {
            /// All words.
            pub const ALL: &[Self] = &[$(Self::$word,)*];

            /// As written in a formula.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Self::$word => $name,)* }
            }

            /// What it is said of.
            #[must_use]
            pub fn takes(self) -> &'static [Sort] {
                match self { $(Self::$word => &[$(Sort::$sort),*],)* }
            }

            /// What it gives.
            #[must_use]
            pub fn gives(self) -> Sort {
                match self { $(Self::$word => Sort::$gives,)* }
            }

            /// How it is read, with {0}, {1}, … for what it is said of.
            #[must_use]
            pub fn says(self) -> &'static str {
                match self { $(Self::$word => $says,)* }
            }
        }
    };
}

words! {
    /// How often a number occurs among the knots.
    Multiplicity "mult" (Real) -> Int "the multiplicity of {0} in U";
    /// Local maxima of a function on the closure of its support; an interval of constancy counts once.
    Maxima "maxima" (Function) -> Int "the number of local maxima of {0}";
    /// Local minima inside the support.
    Minima "minima" (Function) -> Int "the number of local minima of {0}";
    /// Points at which the largest value is taken; 0 if it is only a limit.
    Maximisers "maximisers" (Function) -> Int "the number of x at which {0} takes its largest value";
    /// Of two indices close by, for one the largest value is on one side of a lower point and for the other on the other side:
    /// so there is one between for which it is taken on both.
    Tied "tied" (Function) -> Truth "for an index close by, {0} takes its largest value at two points";
    /// Continuous on (t_0, t_m).
    Continuous "continuous" (Function) -> Truth "{0} is continuous on (t_0, t_m)";
    /// How often the values of an expression change their sign.
    Changes "changes" (Expression) -> Int "the number of sign changes of {0}";
    /// How often control values change their sign, zeros left out.
    PolygonChanges "polygon_changes" (Coefficients) -> Int "the number of sign changes of {0}";
    /// The dimension of the span of the functions of a degree on [t_0, t_m].
    Rank "rank" (Int) -> Int "the dimension of the span of the functions of degree {0}";
    /// Is the expression, on its interval, a combination of the functions of the degree that live there?
    Combination "combination" (Expression, Int) -> Truth "{0} is a combination of the functions of degree {1}";
    /// How often an expression falls on its interval and then rises again; an interval of constancy counts once.
    Valleys "valleys" (Expression) -> Int "the number of local minima of {0}";
    /// No minor of a matrix (G_i(x_j)), x_1 < x_2 < …, is negative.
    TotallyPositive "totally_positive" (Int) -> Truth "the functions of degree {0} have no negative minors at increasing points";
    /// Is every function a combination of those for the knots with one more?
    Nested "nested" (Real) -> Truth "every function is a combination of those for U with one more knot at {0}";
    /// Is every function a combination of those of the next degree on the knots of which each occurs once more?
    Elevated "elevated" (Int) -> Truth "every function of degree {0} is a combination of those of the next degree on U with every knot once more";
    /// The least degree in which the functions on the span of an index are rational Bézier curves with positive weights.
    NurbsDegree "nurbs_degree" (Int) -> Int "the least degree of the curve on span {0} as a rational Bézier curve with positive weights";
    /// Whatever the weights, if they and their complements are positive inside of their intervals.
    FreeWeights "free_weights" (Int) -> Truth "with an index of its own for every weight the functions of degree {0} are positive inside of their supports, 0 outside, and their sum on [t_k, t_{n+1}] is 1";
    /// The supremum of an expression on its interval.
    Supremum "sup" (Expression) -> Real "the supremum of {0}";
    /// Is there a value, or a limit, where an undefined one is a matter of course and no fault of the sentence?
    Defined "defined" (Real) -> Truth "{0} exists";
    /// A quotient of polynomials without a pole on its interval and at the ends of it.
    Rational "rational" (Expression) -> Truth "{0} is a quotient of polynomials without a pole";
    /// Derivatives of all orders on its interval.
    Smooth "smooth" (Expression) -> Truth "{0} has derivatives of all orders";
    /// A stop knot u_i: the i-th of the different knots, from 0.
    Stop "stop" (Int) -> Real "the stop knot of index {0}";
    /// How many different knots there are.
    Stops "stops" () -> Int "the number of stop knots";
    /// Is some point of a plane curve farther than a distance from all points of the curve for α = ∞?
    Strays "strays" (Function, Function, Real) -> Truth "some point of the curve ({0}, {1}) is farther than {2} from all points of the curve for α = ∞";
    /// The least degree of an algebraic curve that holds a plane curve on the span of an index.
    ImplicitDegree "implicit_degree" (Function, Function, Int) -> Int "the least degree of an algebraic curve with the points of ({0}, {1}) on span {2}";
}
