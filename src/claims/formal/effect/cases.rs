//! The functions with the spans on which they turn, ranges of z, and what is known there.

/// Which α.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// α < 0, that is r < 1.
    Below,
    /// α > 1, that is r > 1.
    Above,
}

/// Up or down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Up,
    Down,
}

use Side::{Above, Below};
use Way::{Down, Up};

/// Numbers lo ≤ u ≤ hi, or all u ≥ lo.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part(pub(super) &'static str, pub(super) Option<&'static str>);

/// Functions for which the same numbers do, on one side.
pub(super) struct Case {
    pub(super) side: Side,
    pub(super) degree: usize,
    /// The knot vectors, each with indices i.
    pub(super) functions: &'static [(&'static str, &'static [usize])],
    /// The span on which G_i turns, counted from the span i, as everywhere in a case.
    pub(super) turn: usize,
    /// What is known of it, for ranges of z that begin at 1 and end at 0; nothing if it is empty.
    pub(super) ranges: &'static [Range],
}

/// A range from ≤ z ≤ to.
pub(super) struct Range {
    pub(super) from: &'static str,
    pub(super) to: &'static str,
    /// Where G_i goes one way.
    pub(super) steady: &'static [(Part, Way)],
    /// What bounds D from above (below).
    pub(super) bounds: &'static [Bound],
}

/// D (−D if the way is down) is at most |D| at the point u of the span.
pub(super) struct Bound {
    pub(super) way: Way,
    pub(super) part: Part,
    pub(super) at: (usize, &'static str),
    /// That z is written as a function of u and the parameter, for the sake of a proof.
    pub(super) bent: bool,
}

const fn bound(way: Way, part: Part, span: usize, u: &'static str) -> Bound {
    Bound { way, part, at: (span, u), bent: false }
}

const fn bent(way: Way, part: Part, span: usize, u: &'static str) -> Bound {
    Bound { way, part, at: (span, u), bent: true }
}

const fn upto(hi: &'static str) -> Part {
    Part("0", Some(hi))
}

const fn above(lo: &'static str) -> Part {
    Part(lo, None)
}

const fn between(lo: &'static str, hi: &'static str) -> Part {
    Part(lo, Some(hi))
}

const ALL: Part = above("0");

pub(super) const CASES: &[Case] = &[
    Case {
        side: Below,
        degree: 1,
        functions: &[("U0", &[0, 1, 2, 3, 4])],
        turn: 1,
        ranges: &[Range { from: "0", to: "1", steady: &[(ALL, Up)], bounds: &[] }],
    },
    Case {
        side: Above,
        degree: 1,
        functions: &[("U0", &[0, 1, 2, 3, 4])],
        turn: 1,
        ranges: &[Range { from: "0", to: "1", steady: &[(ALL, Down)], bounds: &[] }],
    },
    Case { side: Below, degree: 2, functions: &[("U1", &[2]), ("U2", &[0])], turn: 1, ranges: &[] },
    Case { side: Above, degree: 2, functions: &[("U1", &[2]), ("U2", &[0])], turn: 1, ranges: &[] },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U0", &[0, 1, 2, 3]), ("U1", &[0])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(upto("1"), Down)],
            bounds: &[bound(Up, above("1"), 2, "1/8"), bound(Down, above("1"), 2, "1")],
        }],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U0", &[0, 1, 2, 3]), ("U1", &[0])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(above("1"), Down)],
            bounds: &[bound(Up, upto("1"), 0, "8"), bound(Down, upto("1"), 0, "1")],
        }],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U1", &[1])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(upto("2/3"), Down)],
            bounds: &[bent(Up, above("2/3"), 1, "1/8"), bound(Down, above("2/3"), 1, "1/2")],
        }],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U1", &[1])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(above("3/4"), Down)],
            bounds: &[bound(Up, upto("3/4"), 0, "8"), bound(Down, upto("3/4"), 0, "4/3")],
        }],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U1", &[3])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/4",
                to: "1",
                steady: &[(upto("1"), Down), (above("8"), Up)],
                bounds: &[bound(Up, between("1", "8"), 1, "10"), bound(Down, between("1", "8"), 2, "1/6")],
            },
            Range {
                from: "1/8",
                to: "1/4",
                steady: &[(upto("6"), Down), (above("20"), Up)],
                bounds: &[bound(Up, between("1", "20"), 2, "1/6"), bound(Down, above("6"), 2, "1/4")],
            },
            Range {
                from: "0",
                to: "1/8",
                steady: &[(upto("10"), Down)],
                bounds: &[bound(Up, above("1"), 2, "1/3"), bound(Down, above("10"), 2, "9/2")],
            },
        ],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U1", &[3])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/10",
                to: "1",
                steady: &[(upto("1/10"), Up), (above("4/3"), Down)],
                bounds: &[
                    bound(Up, between("1/10", "4/3"), 1, "6"),
                    bound(Down, between("1/10", "4/3"), 1, "5/2"),
                ],
            },
            Range {
                from: "0",
                to: "1/10",
                steady: &[(above("1/8"), Down)],
                bounds: &[
                    bent(Up, upto("1/8"), 1, "2"),
                    bound(Up, between("1/8", "4/3"), 1, "3/2"),
                    bound(Down, upto("1/8"), 1, "3/2"),
                ],
            },
        ],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U2", &[1])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(upto("3/2"), Down)],
            bounds: &[bound(Up, above("3/2"), 2, "1/4"), bound(Down, above("3/2"), 2, "4/3")],
        }],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U2", &[1])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/10",
                to: "1",
                steady: &[(upto("1/8"), Up), (above("2"), Down)],
                bounds: &[bound(Up, between("1/8", "2"), 2, "1/8"), bound(Down, between("1/8", "2"), 1, "8")],
            },
            Range {
                from: "0",
                to: "1/10",
                steady: &[(above("1/6"), Down)],
                bounds: &[
                    bent(Up, upto("1/6"), 1, "5"),
                    bound(Up, between("1/6", "2"), 1, "3/2"),
                    bound(Down, upto("1/6"), 1, "3/2"),
                ],
            },
        ],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U2", &[2])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/4",
                to: "1",
                steady: &[(upto("1"), Down), (above("6"), Up)],
                bounds: &[bound(Up, between("1", "6"), 1, "8"), bound(Down, between("1", "6"), 2, "1/6")],
            },
            Range {
                from: "1/8",
                to: "1/4",
                steady: &[(upto("5"), Down), (above("20"), Up)],
                bounds: &[bound(Up, between("1", "20"), 2, "1/6"), bound(Down, above("5"), 2, "1/3")],
            },
            Range {
                from: "0",
                to: "1/8",
                steady: &[(upto("10"), Down)],
                bounds: &[bound(Up, above("1"), 2, "1/3"), bound(Down, above("10"), 2, "5")],
            },
        ],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U2", &[2])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/4",
                to: "1",
                steady: &[(upto("1/6"), Up), (above("1"), Down)],
                bounds: &[bound(Up, between("1/6", "1"), 1, "1/8"), bound(Down, between("1/6", "1"), 0, "6")],
            },
            Range {
                from: "0",
                to: "1/4",
                steady: &[(above("1/5"), Down)],
                bounds: &[bound(Up, upto("1"), 0, "6"), bound(Down, upto("1/5"), 0, "2/5")],
            },
        ],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U2", &[3]), ("U3", &[0])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(upto("3/4"), Down)],
            bounds: &[bound(Up, above("3/4"), 0, "8"), bound(Down, above("3/4"), 2, "4/3")],
        }],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U2", &[3]), ("U3", &[0])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(above("1"), Down)],
            bounds: &[bound(Up, upto("1"), 0, "4"), bound(Down, upto("1"), 0, "2/3")],
        }],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U3", &[1])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(upto("4/3"), Down)],
            bounds: &[bound(Up, above("4/3"), 2, "1/3"), bound(Down, above("4/3"), 2, "2")],
        }],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U3", &[1])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(above("3/2"), Down)],
            bounds: &[bound(Up, upto("3/2"), 2, "1/5"), bound(Down, upto("3/2"), 0, "3/5")],
        }],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U3", &[2])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(upto("1"), Down)],
            bounds: &[bound(Up, above("1"), 2, "1/8"), bound(Down, above("1"), 2, "2/3")],
        }],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U3", &[2])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/4",
                to: "1",
                steady: &[(upto("1/5"), Up), (above("4/3"), Down)],
                bounds: &[
                    bound(Up, between("1/5", "4/3"), 2, "1/10"),
                    bound(Down, between("1/5", "4/3"), 1, "1/20"),
                ],
            },
            Range {
                from: "1/12",
                to: "1/4",
                steady: &[(upto("1/20"), Up), (above("1/4"), Down)],
                bounds: &[bound(Up, between("1/20", "4/3"), 1, "1/20"), bound(Down, upto("1/4"), 0, "7/2")],
            },
            Range {
                from: "0",
                to: "1/12",
                steady: &[(above("1/10"), Down)],
                bounds: &[bound(Up, upto("4/3"), 0, "7/2"), bound(Down, upto("1/10"), 0, "1/5")],
            },
        ],
    },
    Case {
        side: Below,
        degree: 2,
        functions: &[("U3", &[3])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/5",
                to: "1",
                steady: &[(upto("3/4"), Down), (above("8"), Up)],
                bounds: &[
                    bound(Up, between("3/4", "8"), 1, "10"),
                    bound(Down, between("3/4", "8"), 2, "1/3"),
                ],
            },
            Range {
                from: "0",
                to: "1/5",
                steady: &[(upto("6"), Down)],
                bounds: &[bound(Up, above("3/4"), 2, "1/3"), bound(Down, above("6"), 2, "9/2")],
            },
        ],
    },
    Case {
        side: Above,
        degree: 2,
        functions: &[("U3", &[3])],
        turn: 1,
        ranges: &[Range {
            from: "0",
            to: "1",
            steady: &[(above("1"), Down)],
            bounds: &[bound(Up, upto("1"), 0, "8"), bound(Down, upto("1"), 0, "1")],
        }],
    },
    Case {
        side: Below,
        degree: 3,
        functions: &[("U0", &[0, 1, 2])],
        turn: 2,
        ranges: &[
            Range {
                from: "1/4",
                to: "1",
                steady: &[(above("3/2"), Up)],
                bounds: &[bound(Up, upto("3/2"), 2, "3/2"), bound(Down, upto("3/2"), 2, "6")],
            },
            Range {
                from: "1/8",
                to: "1/4",
                steady: &[(upto("4/3"), Down), (above("5"), Up)],
                bounds: &[bound(Up, upto("5"), 2, "6"), bound(Down, above("4/3"), 2, "20")],
            },
            Range {
                from: "1/12",
                to: "1/8",
                steady: &[(upto("4"), Down), (above("8"), Up)],
                bounds: &[bound(Up, upto("8"), 2, "20"), bound(Down, above("4"), 2, "20")],
            },
            Range {
                from: "1/18",
                to: "1/12",
                steady: &[(upto("6"), Down), (above("20"), Up)],
                bounds: &[bound(Up, upto("20"), 2, "20"), bound(Down, above("6"), 3, "1/5")],
            },
            Range {
                from: "0",
                to: "1/18",
                steady: &[(upto("10"), Down)],
                bounds: &[bound(Up, ALL, 3, "1/5"), bound(Down, above("10"), 3, "8")],
            },
        ],
    },
    Case {
        side: Above,
        degree: 3,
        functions: &[("U0", &[0, 1, 2])],
        turn: 1,
        ranges: &[
            Range {
                from: "1/4",
                to: "1",
                steady: &[(upto("2/3"), Up)],
                bounds: &[bound(Up, above("2/3"), 1, "2/3"), bound(Down, above("2/3"), 1, "1/6")],
            },
            Range {
                from: "1/8",
                to: "1/4",
                steady: &[(upto("1/5"), Up), (above("3/4"), Down)],
                bounds: &[bound(Up, above("1/5"), 1, "1/6"), bound(Down, upto("3/4"), 1, "1/20")],
            },
            Range {
                from: "1/12",
                to: "1/8",
                steady: &[(upto("1/8"), Up), (above("1/4"), Down)],
                bounds: &[bound(Up, above("1/8"), 1, "1/20"), bound(Down, upto("1/4"), 1, "1/20")],
            },
            Range {
                from: "1/18",
                to: "1/12",
                steady: &[(upto("1/20"), Up), (above("1/6"), Down)],
                bounds: &[bound(Up, above("1/20"), 1, "1/20"), bound(Down, upto("1/6"), 0, "5")],
            },
            Range {
                from: "0",
                to: "1/18",
                steady: &[(above("1/10"), Down)],
                bounds: &[bound(Up, ALL, 0, "5"), bound(Down, upto("1/10"), 0, "1/8")],
            },
        ],
    },
];
