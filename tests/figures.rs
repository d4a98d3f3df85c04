//! The figures: all there, the same bytes every time, well-formed, and with what they are meant to show.

use std::fs;

use assert_cmd::Command;
use knotproof::claims::claims;
use knotproof::report::figures::{all, figure, png};
use serde_json::Value;

fn svg(name: &str) -> String {
    figure(name).expect("a figure").svg().expect("it can be drawn")
}

fn program(arguments: &[&str]) -> std::process::Output {
    Command::cargo_bin("knotproof").expect("it is built").args(arguments).output().expect("it runs")
}

#[test]
fn the_paper_has_33_figures_and_every_name_is_its_own() {
    let numbers: Vec<_> = all().iter().filter_map(|figure| figure.number).collect();
    assert_eq!(numbers, (1..=33).collect::<Vec<_>>());
    for one in all() {
        assert!(std::ptr::eq(figure(one.name).unwrap(), one), "{}", one.name);
        if let Some(number) = one.number {
            assert_eq!(one.name, format!("fig{number}"));
            assert!(one.title.starts_with(&format!("Fig. {number}: ")), "{}", one.title);
            assert!(std::ptr::eq(figure(&number.to_string()).unwrap(), one));
        }
    }
    assert!(figure("fig34").is_none() && figure("0").is_none() && figure("").is_none());
}

#[test]
fn the_claims_of_a_figure_are_claims_and_every_illustration_has_one() {
    let ids: Vec<_> = claims().iter().map(|claim| claim.id).collect();
    for figure in all() {
        assert!(!figure.claims.is_empty());
        for id in figure.claims {
            assert!(ids.contains(id), "{}: there is no claim {id}", figure.name);
        }
    }
    for id in ids.iter().filter(|id| id.starts_with("Ill") || id.starts_with("Rem")) {
        assert!(all().iter().any(|figure| figure.claims.contains(id)), "no figure for {id}");
    }
}

#[test]
fn every_figure_is_well_formed_and_the_same_every_time() {
    for figure in all() {
        let svg = figure.svg().unwrap();
        assert_eq!(figure.svg().unwrap(), svg, "{}", figure.name);
        assert!(
            svg.contains(&format!(
                "<title>{}</title>",
                figure.title.replace('<', "&lt;").replace('>', "&gt;")
            )),
            "{}",
            figure.name
        );
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{}", figure.name);
        if let Err(error) = resvg::usvg::Tree::from_str(&svg, &resvg::usvg::Options::default()) {
            panic!("{}: {error}", figure.name);
        }
    }
}

#[test]
fn nothing_is_too_fine_for_print() {
    for figure in all() {
        let svg = figure.svg().unwrap();
        // Without what is filled and has no outline.
        let drawn: String = svg.lines().filter(|line| !line.contains("stroke=\"none\"")).collect();
        let values = |name: &str| -> Vec<f64> {
            let pattern = format!(" {name}=\"");
            drawn
                .match_indices(&pattern)
                .map(|(at, _)| drawn[at + pattern.len()..].split('"').next().unwrap().parse().unwrap())
                .collect()
        };
        // A unit is a tenth of a pixel, and a pixel 0.75 pt.
        assert!(values("font-size").iter().all(|size| *size * 0.075 >= 8.0), "{}", figure.name);
        let widths = values("stroke-width");
        assert!(!widths.is_empty() && widths.iter().all(|width| *width * 0.075 >= 0.75), "{}", figure.name);
    }
}

#[test]
fn jumps_have_an_open_and_a_filled_dot() {
    let circles = |svg: &str, open: bool| {
        svg.lines()
            .filter(|line| line.starts_with("<circle") && line.contains("fill=\"none\"") == open)
            .count()
    };
    // U11 has a triple knot, where G_2 falls from 1 to 0 and G_3 rises from 0 to 1: in each of four panels.
    let triple = svg("fig19");
    assert_eq!(circles(&triple, true), 4 * 2);
    // Beside the white inside of each: the two values at the jump, and 1 at both ends.
    assert_eq!(circles(&triple, false), 4 * (2 + 2 + 2));
    // U9 has simple knots only: no jump.
    assert_eq!(circles(&svg("fig17"), true), 0);
    // Degree 0 on U0: six functions, a jump at both ends of each, but not at t_0 and t_m.
    assert_eq!(circles(&svg("fig4"), true), 4 * (6 + 6 - 2));
}

#[test]
fn knots_are_labelled_with_their_multiplicities() {
    let triple = svg("fig19");
    assert_eq!(triple.matches("×3\n").count(), 4 * 3);
    assert!(triple.contains("3/4") && triple.contains("α = ∞") && triple.contains("k = 2"));
    assert_eq!(svg("fig18").matches("×2\n").count(), 4);
}

#[test]
fn png_is_the_same_every_time_and_has_text() {
    let svg = svg("fig12");
    let picture = png(&svg).unwrap();
    assert!(picture.starts_with(b"\x89PNG") && picture == png(&svg).unwrap());
    // Twice as wide as the SVG.
    assert_eq!(picture[16..20], (2 * 800_u32).to_be_bytes());
    let without_text: String = svg.replace("font-size", "data-size");
    assert!(png(&without_text).unwrap() != picture, "the font is not there");
    assert!(png("not an SVG").unwrap_err().to_string().contains("could not be drawn"));
}

#[test]
fn the_command_writes_what_the_library_draws() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new");
    let arguments =
        ["figures", "12", "two-maxima", "fig12", "--format", "json", "--out", out.to_str().unwrap()];
    let output = program(&arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(result["schema"], "knotproof.figures/1");
    let files: Vec<_> =
        result["files"].as_array().unwrap().iter().map(|file| file.as_str().unwrap()).collect();
    let names = ["fig12.svg", "fig12.png", "two-maxima.svg", "two-maxima.png"];
    assert_eq!(files, names.map(|name| out.join(name).to_str().unwrap().to_owned()));
    assert_eq!(fs::read_to_string(files[0]).unwrap(), svg("fig12"));
    assert_eq!(fs::read(files[1]).unwrap(), png(&svg("fig12")).unwrap());
    assert_eq!(result["figures"][1]["claims"][0], "Conj3.1.strong");
}

#[test]
fn an_unknown_figure_is_told_which_there_are() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new");
    let output = program(&["figures", "34", "--out", out.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        message.contains("no figure `34`") && message.contains("1 to 33") && message.contains("two-maxima")
    );
    assert!(output.stdout.is_empty() && !out.exists());
}
