//! NURBS curves as a STEP file.

use std::fmt::{Display, Write};

use super::Rounded;

/// What stands before the curves: a product whose shape is the set of curves #16, in millimetres.
const HEAD: &str = "\
ISO-10303-21;
HEADER;
FILE_DESCRIPTION(('rational B-splines as NURBS curves'),'2;1');
FILE_NAME('','',(''),(''),'knotproof','knotproof','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('core data for automotive mechanical design processes');
#2=APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#1);
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('curve','curve','',(#3));
#5=PRODUCT_RELATED_PRODUCT_CATEGORY('part','',(#4));
#6=PRODUCT_DEFINITION_FORMATION('','',#4);
#7=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#8=PRODUCT_DEFINITION('design','',#6,#7);
#9=PRODUCT_DEFINITION_SHAPE('','',#8);
#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#11=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#12=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#13=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#10,#11,#12))REPRESENTATION_CONTEXT('',''));
#14=SHAPE_DEFINITION_REPRESENTATION(#9,#15);
#15=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#16),#13);
";

/// The whole file.
pub(super) fn file(curves: &[Rounded]) -> String {
    let (mut entities, mut names) = (String::new(), Vec::new());
    let mut next = 17;
    for curve in curves {
        let name = next;
        next += 1 + curve.points.len();
        names.push(format!("#{name}"));
        let points = list((name + 1..next).map(|point| format!("#{point}")));
        let stops: Vec<_> = curve.knots.chunk_by(|a, b| a.total_cmp(b).is_eq()).collect();
        let copies = list(stops.iter().map(|stop| stop.len()));
        let knots = list(stops.iter().map(|stop| real(stop[0])));
        let weights = list(curve.weights.iter().map(|&w| real(w)));
        // Writing to a string cannot fail.
        let _ = writeln!(
            entities,
            "#{name}=(BOUNDED_CURVE()B_SPLINE_CURVE({},{points},.UNSPECIFIED.,.F.,.F.)\
             B_SPLINE_CURVE_WITH_KNOTS({copies},{knots},.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE({weights})REPRESENTATION_ITEM(''));",
            curve.degree
        );
        for (point, place) in (name + 1..next).zip(curve.points_in(3)) {
            let place = list(place.into_iter().map(real));
            let _ = writeln!(entities, "#{point}=CARTESIAN_POINT('',{place});");
        }
    }
    format!("{HEAD}#16=GEOMETRIC_CURVE_SET('',{});\n{entities}ENDSEC;\nEND-ISO-10303-21;\n", list(names))
}

fn list(entries: impl IntoIterator<Item = impl Display>) -> String {
    let entries: Vec<_> = entries.into_iter().map(|entry| entry.to_string()).collect();
    format!("({})", entries.join(","))
}

/// A real number of ISO 10303-21 has a decimal point, and `E` before its exponent.
fn real(x: f64) -> String {
    let text = format!("{x:?}");
    match text.split_once('e') {
        Some((digits, exponent)) if digits.contains('.') => format!("{digits}E{exponent}"),
        Some((digits, exponent)) => format!("{digits}.E{exponent}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_have_a_decimal_point() {
        for (x, text) in [(0.0, "0.0"), (-0.1, "-0.1"), (1e300, "1.E300"), (-2.5e-7, "-2.5E-7")] {
            assert_eq!(real(x), text);
        }
    }
}
