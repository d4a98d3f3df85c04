//! Integers of a sentence at a place, where the span s and n have no value: c + a·s + b·n + …, and what is known of them.

/// c + a·s + b·n + Σ e_j·z_j, with integers z_j ≥ 0 of which nothing else is known: how far an index is from all that the
/// window shows, how often a knot occurs beyond the copies told apart.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Default)]
pub(super) struct Index {
    pub(super) c: i64,
    s: i64,
    n: i64,
    /// (j, e_j), by rising j, without those that are 0: of many z_j one or two occur.
    z: Vec<(usize, i64)>,
}

/// From a least to a greatest value; `None` where there is none.
pub(super) type Bounds = (Option<i64>, Option<i64>);

impl Index {
    pub(super) const fn number(c: i64) -> Self {
        Self { c, s: 0, n: 0, z: Vec::new() }
    }

    /// s + e.
    pub(super) const fn span(e: i64) -> Self {
        Self { c: e, s: 1, n: 0, z: Vec::new() }
    }

    /// n + e.
    pub(super) const fn last(e: i64) -> Self {
        Self { c: e, s: 0, n: 1, z: Vec::new() }
    }

    /// z_j.
    pub(super) fn beyond(j: usize) -> Self {
        Self { z: vec![(j, 1)], ..Self::default() }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        sum.add(1, other);
        sum
    }

    /// Adds a multiple of another.
    fn add(&mut self, factor: i64, other: &Self) {
        self.c += factor * other.c;
        self.s += factor * other.s;
        self.n += factor * other.n;
        for (j, e) in &other.z {
            match self.z.binary_search_by_key(j, |own| own.0) {
                Ok(at) if self.z[at].1 + factor * e == 0 => drop(self.z.remove(at)),
                Ok(at) => self.z[at].1 += factor * e,
                Err(at) => self.z.insert(at, (*j, factor * e)),
            }
        }
    }

    pub(super) fn times(&self, factor: i64) -> Self {
        if factor == 0 {
            return Self::default();
        }
        let z = self.z.iter().map(|(j, e)| (*j, e * factor)).collect();
        Self { c: self.c * factor, s: self.s * factor, n: self.n * factor, z }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        let mut difference = self.clone();
        difference.add(-1, other);
        difference
    }

    /// The integers by which it is told from others: c, a, b, e_0, ….
    pub(super) fn key(&self) -> impl Iterator<Item = i64> + '_ {
        let count = self.z.last().map_or(0, |(j, _)| j + 1);
        [self.c, self.s, self.n].into_iter().chain((0..count).map(|j| self.beyonds(j)))
    }

    /// e_j.
    fn beyonds(&self, j: usize) -> i64 {
        self.z.binary_search_by_key(&j, |own| own.0).map_or(0, |at| self.z[at].1)
    }
}

/// The three ways to write a·s + b·n by two of s, n − s and n.
fn ways(a: i64, b: i64) -> [[i64; 3]; 3] {
    [[a + b, b, 0], [a, 0, b], [0, -a, a + b]]
}

/// What is known of s, n − s and n, and which integers are known not to be negative.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Facts {
    bounds: [Bounds; 3],
    asserted: Vec<Index>,
}

/// What was assumed can't be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Contradiction;

impl Facts {
    pub(super) fn new(s: Bounds, rest: Bounds) -> Result<Self, Contradiction> {
        let mut facts = Self { bounds: [s, rest, (Some(0), None)], asserted: Vec::new() };
        facts.settle()?;
        Ok(facts)
    }

    /// The bounds of an integer; where both are the same it is known.
    pub(super) fn of(&self, index: &Index) -> Bounds {
        let without = |sign: i64| index.z.iter().all(|(_, e)| e * sign >= 0);
        let of = |one: i64| self.lowest(one * index.c, one * index.s, one * index.n);
        (of(1).filter(|_| without(1)), of(-1).filter(|_| without(-1)).map(|most| -most))
    }

    /// The greatest known lower bound of c + a·s + b·n.
    fn lowest(&self, c: i64, a: i64, b: i64) -> Option<i64> {
        let ways = ways(a, b).into_iter();
        ways.filter_map(|way| {
            let mut parts = way.iter().zip(&self.bounds);
            parts.try_fold(c, |sum, (e, bounds)| both(Some(sum), scaled(*e, *bounds).0))
        })
        .max()
    }

    /// Is v − Σ known ≥ 0 by the bounds alone?
    fn is_surely(&self, v: &Index, known: &[&Index]) -> bool {
        let left =
            |part: &dyn Fn(&Index) -> i64| part(v) - known.iter().map(|known| part(known)).sum::<i64>();
        self.lowest(left(&|i| i.c), left(&|i| i.s), left(&|i| i.n)).is_some_and(|lowest| lowest >= 0)
            && known.iter().chain([&v]).flat_map(|i| &i.z).all(|(j, _)| left(&|i| i.beyonds(*j)) >= 0)
    }

    /// Its value, if it has only one.
    pub(super) fn value(&self, index: &Index) -> Option<i64> {
        match self.of(index) {
            (Some(low), Some(high)) if low == high => Some(low),
            _ => None,
        }
    }

    /// Is it ≥ 0: yes, no, or not known?
    pub(super) fn at_least_zero(&self, index: &Index) -> Option<bool> {
        let asserted = &self.asserted;
        let surely = |v: &Index| {
            let after = |(at, one): (usize, &Index)| {
                self.is_surely(v, &[one]) || asserted[at..].iter().any(|two| self.is_surely(v, &[one, two]))
            };
            self.is_surely(v, &[]) || asserted.iter().enumerate().any(after)
        };
        // −index − 1 ≥ 0.
        let opposite = index.times(-1).plus(&Index::number(-1));
        if surely(index) {
            Some(true)
        } else if surely(&opposite) {
            Some(false)
        } else {
            None
        }
    }

    /// That it is ≥ 0.
    pub(super) fn assume(&mut self, index: &Index) -> Result<(), Contradiction> {
        match self.at_least_zero(index) {
            Some(true) => return Ok(()),
            Some(false) => return Err(Contradiction),
            None => self.asserted.push(index.clone()),
        }
        let z_high = if index.z.iter().any(|(_, e)| *e > 0) { None } else { Some(0) };
        for way in ways(index.s, index.n) {
            for at in 0..3 {
                // way[at]·X ≥ −(all others), which is at least minus their greatest value.
                let others = (0..3).filter(|other| *other != at);
                let most = others.map(|other| scaled(way[other], self.bounds[other]).1);
                let most = most.chain([z_high]).try_fold(index.c, |sum, e| Some(sum + e?));
                match (way[at], most) {
                    (1, Some(most)) => self.bounds[at].0 = self.bounds[at].0.max(Some(-most)),
                    (-1, Some(most)) => self.bounds[at].1 = least(self.bounds[at].1, Some(most)),
                    _ => {}
                }
            }
        }
        self.settle()
    }

    /// s + (n − s) = n, until nothing follows any more.
    fn settle(&mut self) -> Result<(), Contradiction> {
        loop {
            let before = self.bounds;
            let [s, rest, n] = before;
            let minus = |a: Option<i64>, b: Option<i64>| Some(a? - b?);
            self.bounds = [
                (s.0.max(minus(n.0, rest.1)), least(s.1, minus(n.1, rest.0))),
                (rest.0.max(minus(n.0, s.1)), least(rest.1, minus(n.1, s.0))),
                (n.0.max(both(s.0, rest.0)), least(n.1, both(s.1, rest.1))),
            ];
            if self.bounds.iter().any(|b| matches!(b, (Some(low), Some(high)) if low > high)) {
                return Err(Contradiction);
            }
            if self.bounds == before {
                return Ok(());
            }
        }
    }
}

/// The sum, if there are both.
fn both(a: Option<i64>, b: Option<i64>) -> Option<i64> {
    Some(a? + b?)
}

/// The smaller one of those that there are.
fn least(a: Option<i64>, b: Option<i64>) -> Option<i64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

/// The bounds of e·X.
fn scaled(e: i64, (low, high): Bounds) -> Bounds {
    let times = |bound: Option<i64>| bound.map(|bound| bound * e);
    match e {
        0 => (Some(0), Some(0)),
        1.. => (times(low), times(high)),
        _ => (times(high), times(low)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_follow_from_each_other() {
        // k = 2, open: s ≥ 2, n − s ≥ 0.
        let mut facts = Facts::new((Some(0), None), (Some(-2), None)).unwrap();
        facts.assume(&Index::span(-2)).unwrap();
        facts.assume(&Index::last(0).minus(&Index::span(0))).unwrap();
        assert_eq!(facts.of(&Index::last(0)), (Some(2), None));
        // bernstein: m = n + 3 = 5.
        facts.assume(&Index::last(-2)).unwrap();
        facts.assume(&Index::last(-2).times(-1)).unwrap();
        assert_eq!(facts.value(&Index::span(0)), Some(2));
        assert_eq!(facts.assume(&Index::span(-3)), Err(Contradiction));
    }

    #[test]
    fn what_was_assumed_is_known() {
        let mut facts = Facts::new((Some(0), None), (Some(-2), None)).unwrap();
        let far = Index::span(-8).minus(&Index::beyond(0));
        assert_eq!(facts.at_least_zero(&far), None);
        facts.assume(&far).unwrap();
        assert_eq!(facts.at_least_zero(&far.plus(&Index::number(1))), Some(true));
        assert_eq!(facts.at_least_zero(&far.plus(&Index::number(1)).times(-1)), Some(false));
        assert_eq!(facts.of(&Index::span(0)).0, Some(8));
    }
}
