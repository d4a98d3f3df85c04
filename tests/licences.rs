//! Every dependency may be used under a permissive licence.

use std::process::Command;

use serde_json::Value;

/// Licences that ask for no more than attribution. MPL-2.0 and the GPL family are left out on purpose.
const PERMISSIVE: [&str; 10] = [
    "MIT",
    "MIT-0",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "ISC",
    "Unlicense",
    "Zlib",
    "Unicode-3.0",
];

/// Can all that the expression asks for be met with permissive licences? `AND` binds tighter than `OR`.
fn permissive(expression: &str) -> bool {
    let expression = expression.replace(['(', ')'], " ").replace('/', " OR ");
    expression.split(" OR ").any(|all| all.split(" AND ").all(|one| PERMISSIVE.contains(&one.trim())))
}

#[test]
fn the_licences_of_all_dependencies_are_permissive() {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    assert!(packages.len() > 50, "the dependencies are missing from the list");
    for package in packages {
        let (name, licence) = (&package["name"], package["license"].as_str().unwrap_or("none"));
        let mixed = licence.contains('(') && licence.contains("AND");
        let parts_hold = !mixed || licence.split(" AND ").all(permissive);
        assert!(permissive(licence) && parts_hold, "{name}: {licence}");
    }
}

#[test]
fn other_licences_are_noticed() {
    assert!(permissive("MIT OR Apache-2.0") && permissive("MPL-2.0 OR MIT"));
    assert!(!permissive("GPL-3.0") && !permissive("MIT AND LGPL-3.0"));
}

/// A version is written where it is read: in the manifest, for who cites it, and at the head of what changed.
#[test]
fn the_version_is_one() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| std::fs::read_to_string(root.join(name)).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    assert!(read("CITATION.cff").contains(&format!("\nversion: {version}\n")));
    let changes = read("CHANGELOG.md");
    let first = changes.lines().find(|line| line.starts_with("## ")).unwrap();
    assert!(first.starts_with(&format!("## {version} ")), "{first}");
    for section in ["Added", "Changed", "Fixed", "Security"] {
        assert!(changes.contains(&format!("\n### {section}\n")), "{section}");
    }
}
