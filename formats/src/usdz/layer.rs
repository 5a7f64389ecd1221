//! A layer in memory: specs with fields, as a tree.

/// A prim or a property, or the layer itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// Without the path above it; empty for the layer itself.
    pub name: String,
    pub kind: Kind,
    pub fields: Vec<(String, Value)>,
    pub children: Vec<Spec>,
}

/// With the numbers of the crate format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Attribute = 1,
    Prim = 6,
    Root = 7,
    Relationship = 8,
}

/// The types of values that a model needs.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Bool(bool),
    Int(i32),
    Float(f32),
    Double(f64),
    String(String),
    Token(String),
    Asset(String),
    Vec3f([f32; 3]),
    Vec4f([f32; 4]),
    Ints(Vec<i32>),
    Floats(Vec<f32>),
    /// w first.
    Quatfs(Vec<[f32; 4]>),
    Vec2fs(Vec<[f32; 2]>),
    Vec3fs(Vec<[f32; 3]>),
    Tokens(Vec<String>),
    /// Prepended to what weaker layers say.
    TokenList(Vec<String>),
    /// Absolute paths.
    PathList(Vec<String>),
    Dictionary(Vec<(String, Value)>),
    /// 0 is `def`.
    Specifier(u32),
    /// 1 is `uniform`.
    Variability(u32),
    /// A type that is not read here.
    Other(u8),
}

impl Spec {
    pub fn new(name: impl Into<String>, kind: Kind) -> Self {
        Spec { name: name.into(), kind, fields: Vec::new(), children: Vec::new() }
    }

    /// A defined prim; its type may be empty.
    pub fn prim(name: impl Into<String>, kind: &str) -> Self {
        let prim = Spec::new(name, Kind::Prim).with("specifier", Value::Specifier(0));
        if kind.is_empty() { prim } else { prim.with("typeName", Value::Token(kind.into())) }
    }

    pub fn attribute(name: &str, kind: &str, value: Value) -> Self {
        Spec::new(name, Kind::Attribute).with("typeName", Value::Token(kind.into())).with("default", value)
    }

    pub fn uniform(name: &str, token: &str) -> Self {
        Spec::new(name, Kind::Attribute)
            .with("typeName", Value::Token("token".into()))
            .with("variability", Value::Variability(1))
            .with("default", Value::Token(token.into()))
    }

    /// An attribute that takes its value from another.
    pub fn connected(name: &str, kind: &str, path: String) -> Self {
        Spec::new(name, Kind::Attribute)
            .with("typeName", Value::Token(kind.into()))
            .with("connectionPaths", Value::PathList(vec![path]))
    }

    pub fn with(mut self, field: &str, value: Value) -> Self {
        self.fields.push((field.into(), value));
        self
    }

    pub fn child(mut self, child: Spec) -> Self {
        self.children.push(child);
        self
    }

    pub fn field(&self, name: &str) -> Option<&Value> {
        self.fields.iter().find(|(n, _)| n == name).map(|(_, value)| value)
    }

    /// The default value of an attribute below.
    pub fn value(&self, name: &str) -> Option<&Value> {
        self.children.iter().find(|c| c.kind == Kind::Attribute && c.name == name)?.field("default")
    }

    pub fn type_name(&self) -> &str {
        match self.field("typeName") {
            Some(Value::Token(name)) => name,
            _ => "",
        }
    }
}
