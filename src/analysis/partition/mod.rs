//! A function of one parameter, by the number of its local maxima.

mod bernstein_table;
mod boxes;
mod family;
mod sweep;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::LocalKnots;
    use crate::scalar::{Polynomial, Ring};
    use num_bigint::BigInt;

    #[test]
    fn explore() {
        let kmax: usize = std::env::var("KMAX").map_or(4, |k| k.parse().unwrap());
        for k in 2..=kmax {
            for reverse in [false] {
                let _ = reverse;
                let t0 = std::time::Instant::now();
                let one = Polynomial::constant(BigInt::from(1));
                let t = Polynomial::variable(&BigInt::from(1));
                let gaps = vec![one.clone(); k + 1];
                let local = LocalKnots::new(gaps, (t, one)).unwrap();
                let f = family::Family::new(&local);
                eprintln!("k={k} family {:?}", t0.elapsed());
                let parts = sweep::sweep(&f, true, 20);
                eprintln!("k={k} sweep {:?} {}", t0.elapsed(), parts.len());
                for p in &parts {
                    if p.content != sweep::Content::Constant {
                        let (a, b) = (f.local_maxima(&p.from.clone().max(crate::scalar::rational(1, 1 << 30))), f.local_maxima(&p.to));
                        use num_traits::ToPrimitive;
                        eprintln!("  [{},{}] {:?} {a} {b}", p.from.to_f64().unwrap(), p.to.to_f64().unwrap(), p.content);
                    }
                }
                eprintln!("k={k} all {:?}", t0.elapsed());
            }
        }
    }
}
